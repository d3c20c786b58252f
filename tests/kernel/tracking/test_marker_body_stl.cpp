// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <numbers>

#include "stl_support.hpp"
#include "tracking/print/marker_body_stl.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

MarkerBody printed_phaco() {
    MarkerBody body{"phaco", {{0, 20, 0}, {24, -5, 0}, {-18, 12, 8}, {-4, -18, 30}}, 3.0, {}};
    body.tip.position = {0, 0, -95};
    return body;
}

/// A rod along z, its tip at the origin.
Replica rod_replica(double length, double radius) {
    const std::array<RoundedCone, 1> rod{{{Vec3::Zero(), {0.0, 0.0, length}, radius, radius}}};
    return {handle_of(rod, "rod").value(), {}};
}

std::string print_error(const MarkerBody& body, const MarkerBodyPrint& print = {}) {
    const Result<std::string> stl = marker_body_stl(body, rod_replica(120.0, 4.0), print);
    return stl ? std::string("ok") : stl.error().text();
}

std::vector<Vec3> corners_of_box() {
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    return {o, y,     x,     x,     y,         x + y,       // below
            o, x,     z,     x,     x + z,     z,           // before
            o, z,     y,     y,     z,         y + z,       // left
            x, x + y, x + z, x + y, x + y + z, x + z,       // right
            z, x + z, y + z, y + z, x + z,     x + y + z,   // above
            y, y + z, x + y, x + y, y + z,     x + y + z};  // behind
}

}  // namespace

TEST_CASE("sleeve and struts are closed shells of positive volume, with normals outwards") {
    const Result<std::string> stl = marker_body_stl(printed_phaco(), rod_replica(120.0, 4.0));
    REQUIRE_MESSAGE(stl.ok(), (stl ? "" : stl.error().text()));
    const std::vector<StlFacet> facets = read_stl(stl.value());
    const std::vector<StlShell> shells = closed_shells_of(facets);
    REQUIRE(shells.size() == 5);
    for (const StlShell& shell : shells) {
        CHECK(shell.volume > 0.0);
    }
    for (const StlFacet& facet : facets) {
        const Vec3 turn = (vector_of(facet[2]) - vector_of(facet[1])).cross(vector_of(facet[3]) - vector_of(facet[1]));
        CHECK(turn.norm() > 0.0);
        CHECK(turn.normalized().dot(vector_of(facet[0])) > 0.999);
    }
}

TEST_CASE("seats, pins and the bore have the sizes that were asked for") {
    const MarkerBody body = printed_phaco();
    MarkerBodyPrint print;
    print.mount.clearance = 0.2;
    const std::vector<StlFacet> facets = read_stl(marker_body_stl(body, rod_replica(120.0, 4.0), print).value());
    for (const Vec3& marker : body.markers) {
        double nearest = 1e9;
        double seat = 0.0;
        for (const StlFacet& facet : facets) {
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
    for (const StlFacet& facet : facets) {
        for (std::size_t i = 1; i < 4; ++i) {
            bore = std::min(bore, vector_of(facet[i]).head<2>().norm());
        }
    }
    CHECK(bore == doctest::Approx(4.2).epsilon(1e-4));  // nothing reaches into it
}

TEST_CASE("with the instrument's shape the sleeve is solid, and the shape is where the tip has it") {
    MarkerBody body = printed_phaco();
    body.tip.orientation = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
    Replica replica = rod_replica(120.0, 4.0);
    replica.handle = moved_to({Vec3::Zero(), body.tip.orientation.conjugate()}, *replica.handle);
    const Result<Solid> box = closed_shell(corners_of_box(), "box");
    REQUIRE(box.ok());
    replica.shape = {box.value()};
    const std::vector<StlShell> shells = closed_shells_of(read_stl(marker_body_stl(body, replica).value()));
    REQUIRE(shells.size() == 6);
    CHECK(shells[0].volume == doctest::Approx(1.0));
    double far_corner = 1e9;
    for (const StlFacet& facet : shells[0].facets) {
        for (std::size_t i = 1; i < 4; ++i) {
            far_corner = std::min(far_corner, (vector_of(facet[i]) - body.tip.to_world({1, 1, 1})).norm());
        }
    }
    CHECK(far_corner < 1e-4);
    double length = 0.0;
    for (const StlFacet& facet : shells[1].facets) {
        length = std::max(length, vector_of(facet[1]).z());
    }
    double from = 1e9;
    for (const StlFacet& facet : shells[1].facets) {
        from = std::min(from, static_cast<double>(facet[1][2]));
    }
    const double radius = 7.1;
    CHECK(shells[1].volume == doctest::Approx(std::numbers::pi * radius * radius * (length - from)).epsilon(0.01));
}

TEST_CASE("a short thread is gone on with by a rod that the sleeve is about") {
    const Replica thread = rod_replica(25.0, 0.15);
    MarkerBody body = printed_phaco();
    body.tip.position = {0, 0, -65};
    const Result<std::string> stl = marker_body_stl(body, thread);
    REQUIRE_MESSAGE(stl.ok(), (stl ? "" : stl.error().text()));
    const std::vector<StlShell> shells = closed_shells_of(read_stl(stl.value()));
    REQUIRE(shells.size() == 5);
    double begins = 1e9;
    for (const StlFacet& facet : shells[0].facets) {
        begins = std::min(begins, static_cast<double>(facet[1][2]));
    }
    CHECK(begins == doctest::Approx(-65.0 + 15.0));
}

TEST_CASE("a head's body stands on a plate") {
    const MarkerBody head{"head", {{40, 0, -16}, {8, 37, 15}, {-46, 7, -14}, {-2, -42, 16}}, 3.0, {}};
    const std::vector<StlShell> shells = closed_shells_of(read_stl(marker_body_stl(head, {}).value()));
    REQUIRE(shells.size() == 5);
    CHECK(shells[0].volume == doctest::Approx(std::numbers::pi * 144.0 * 5.0).epsilon(0.01));
}

TEST_CASE("a body that cannot be printed so is refused with the marker that is in the way") {
    CHECK(print_error(printed_phaco()) == "ok");
    MarkerBody within = printed_phaco();
    within.markers[1] = {0, -6, 0};
    CHECK(print_error(within).find("no room for a strut to marker 2") != std::string::npos);
    MarkerBody hidden = printed_phaco();
    hidden.markers = {{0, 16, 0}, {0, 21.7, 0}, {20, -10, 0}, {-20, -10, 0}};
    CHECK(print_error(hidden).find("no room for a strut to marker 2") != std::string::npos);
    MarkerBodyPrint thick;
    thick.mount.strut_radius = 2.9;
    CHECK(print_error(printed_phaco(), thick).find("strut_radius is 2.9") != std::string::npos);
    MarkerBodyPrint pin;
    pin.pin_length = 20.0;
    CHECK(print_error(printed_phaco(), pin).find("pin_length is 20") != std::string::npos);
}

TEST_CASE("holes of a shell are closed, and what is no surface is refused") {
    std::vector<Vec3> open = corners_of_box();
    open.resize(open.size() - 6);  // without a side
    const Result<Solid> box = closed_shell(open, "box");
    REQUIRE(box.ok());
    CHECK(box.value().size() == 10 + 4);
    double volume = 0.0;
    for (const Triangle& triangle : box.value()) {
        volume += triangle[0].dot(triangle[1].cross(triangle[2])) / 6.0;
    }
    CHECK(volume == doctest::Approx(1.0));
    std::vector<Vec3> twice = corners_of_box();
    twice.insert(twice.end(), twice.begin(), twice.begin() + 3);
    CHECK(closed_shell(twice, "box").error().text().find("box") != std::string::npos);
}

}  // namespace rhexis::tracking
