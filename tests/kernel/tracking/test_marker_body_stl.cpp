// SPDX-License-Identifier: GPL-3.0-or-later
// What is read back from the file of a body to be printed.
#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <map>

#include "tracking/marker_body_stl.hpp"

namespace rhexis::tracking {
namespace {

using Corner = std::array<float, 3>;
using Facet = std::array<Corner, 4>;  // normal, then corners

MarkerBody printed_phaco() {
    MarkerBody body{"phaco", {{0, 40, 0}, {24, 45, 0}, {-8, 62, 8}, {-14, 38, 30}}, 3.0, {}};
    body.tip.position = {0, 0, -120};
    return body;
}

std::vector<Facet> read_stl(const std::string& bytes) {
    REQUIRE(bytes.size() >= 84);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    REQUIRE(bytes.size() == 84 + 50 * static_cast<std::size_t>(count));
    std::vector<Facet> facets(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(facets[i].data(), bytes.data() + 84 + 50 * i, sizeof(Facet));
    }
    return facets;
}

Vec3 vector_of(const Corner& corner) { return {corner[0], corner[1], corner[2]}; }

/// Facets that hang together by edges, each shell by itself: they follow one another in the file, so a new one begins
/// where all edges before are paired.
struct Shell {
    double volume = 0.0;
    int facets = 0;
};

std::vector<Shell> shells_of(const std::vector<Facet>& facets) {
    std::vector<Shell> shells(1);
    std::map<std::pair<Corner, Corner>, int> open;  // edges that still lack their opposite
    for (const Facet& facet : facets) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner& from = facet[1 + i];
            const Corner& to = facet[1 + (i + 1) % 3];
            const auto opposite = open.find({to, from});
            if (opposite != open.end()) {
                open.erase(opposite);
            } else {
                const bool first = open.emplace(std::make_pair(from, to), 1).second;
                REQUIRE(first);
            }
        }
        shells.back().volume += vector_of(facet[1]).dot(vector_of(facet[2]).cross(vector_of(facet[3]))) / 6.0;
        ++shells.back().facets;
        if (open.empty()) {
            shells.emplace_back();
        }
    }
    CHECK(open.empty());
    shells.pop_back();
    return shells;
}

std::string print_error(const MarkerBody& body, const MarkerBodyPrint& print = {}) {
    const Result<std::string> stl = marker_body_stl(body, print);
    return stl ? std::string("ok") : stl.error().text();
}

}  // namespace

TEST_CASE("ring, bar and posts are closed shells of positive volume, with normals outwards") {
    const Result<std::string> stl = marker_body_stl(printed_phaco());
    REQUIRE_MESSAGE(stl.ok(), (stl ? "" : stl.error().text()));
    const std::vector<Facet> facets = read_stl(stl.value());
    const std::vector<Shell> shells = shells_of(facets);
    REQUIRE(shells.size() == 6);
    for (const Shell& shell : shells) {
        CHECK(shell.volume > 0.0);
    }
    const double pi = 3.14159265358979;
    CHECK(shells[0].volume == doctest::Approx(pi * (7.1 * 7.1 - 4.1 * 4.1) * 8.0).epsilon(0.01));
    for (const Facet& facet : facets) {
        const Vec3 turn = (vector_of(facet[2]) - vector_of(facet[1])).cross(vector_of(facet[3]) - vector_of(facet[1]));
        CHECK(turn.norm() > 0.0);
        CHECK(turn.normalized().dot(vector_of(facet[0])) > 0.999);
    }
}

TEST_CASE("seats, pins and the ring have the sizes that were asked for") {
    const MarkerBody body = printed_phaco();
    MarkerBodyPrint print;
    print.clearance = 0.2;
    const std::vector<Facet> facets = read_stl(marker_body_stl(body, print).value());
    for (const Vec3& marker : body.markers) {
        double nearest = 1e9;
        double seat = 0.0;
        for (const Facet& facet : facets) {
            for (std::size_t i = 1; i < 4; ++i) {
                const double distance = (vector_of(facet[i]) - marker).norm();
                nearest = std::min(nearest, distance);
                seat = distance < 3.2 + 1e-4 ? std::max(seat, distance) : seat;
            }
        }
        CHECK(nearest == doctest::Approx(1.2).epsilon(1e-4));  // the pin's end: 2 mm above the seat
        CHECK(seat == doctest::Approx(3.2).epsilon(1e-4));
    }
    double bore = 1e9;
    for (const Facet& facet : facets) {
        for (std::size_t i = 1; i < 4; ++i) {
            bore = std::min(bore, vector_of(facet[i]).head<2>().norm());
        }
    }
    CHECK(bore == doctest::Approx(4.2).epsilon(1e-4));  // nothing reaches into it
}

TEST_CASE("a body that cannot be printed so is refused with the marker that is in the way") {
    CHECK(print_error(printed_phaco()) == "ok");
    MarkerBody across = printed_phaco();
    across.markers[1] = {0, -60, 0};
    CHECK(print_error(across).find("the post of marker 2 meets the shaft") != std::string::npos);
    MarkerBody hidden = printed_phaco();
    hidden.markers = {{0, 70, 0}, {0, 95, 0}, {30, 20, 0}, {-30, 20, 0}};
    CHECK(print_error(hidden).find("meets the sphere of marker 1") != std::string::npos);
    MarkerBody middle = printed_phaco();
    middle.markers = {{0, 50, 0}, {20, 50, 0}, {-20, 50, 0}};
    CHECK(print_error(middle).find("the post of marker 1 has no room") != std::string::npos);
    MarkerBodyPrint thick;
    thick.post_radius = 2.9;
    CHECK(print_error(printed_phaco(), thick).find("post_radius is 2.9") != std::string::npos);
}

}  // namespace rhexis::tracking
