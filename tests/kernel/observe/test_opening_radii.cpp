// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that a capsulorhexis left, by its distance from the axis.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "kernel/observe/cut.hpp"
#include "observe/opening_radii.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

/// Distance from the axis at which a ray at an angle leaves an ellipse about a centre that holds the axis [mm].
double exact_radius(double a, double b, const Vec2& centre, double angle) {
    const Vec2 ray(std::cos(angle) / a, std::sin(angle) / b);
    const Vec2 middle(centre.x() / a, centre.y() / b);
    const double along = ray.dot(middle) / ray.squaredNorm();
    return along + std::sqrt(along * along + (1.0 - middle.squaredNorm()) / ray.squaredNorm());
}

struct Deviation {
    double most = 0.0;
    double root_mean_square = 0.0;
};

Deviation deviation(const std::vector<double>& radii, double a, double b, const Vec2& centre) {
    Deviation off;
    for (int i = 0; i < static_cast<int>(radii.size()); ++i) {
        const double angle = 2.0 * pi * i / static_cast<double>(radii.size());
        const double here = radii[at(i)] - exact_radius(a, b, centre, angle);
        off.most = std::max(off.most, std::abs(here));
        off.root_mean_square += here * here / static_cast<double>(radii.size());
    }
    off.root_mean_square = std::sqrt(off.root_mean_square);
    return off;
}

std::vector<Vec2> polygon(const Line& line, int corners) {
    std::vector<Vec2> ring;
    for (int i = 0; i < corners; ++i) {
        ring.push_back(line(0.3 + 2.0 * pi * i / corners));
    }
    return ring;
}

std::string refusal(const Result<std::vector<double>>& radii) { return radii ? "" : radii.error().what; }

}  // namespace

TEST_SUITE("opening radii") {
    TEST_CASE("of a fine polygon: circle and off-centre ellipse to a thousandth of a millimetre, whichever way round") {
        const Vec2 centre(0.6, -0.4);
        std::vector<Vec2> ring = polygon(ellipse(3.0, 2.2, centre), 400);
        for (int way = 0; way < 2; ++way) {
            const Result<std::vector<double>> radii = ring_radii(ring);
            REQUIRE(radii.ok());
            REQUIRE(radii.value().size() == 64);
            CHECK(deviation(radii.value(), 3.0, 2.2, centre).most < 1e-3);
            std::reverse(ring.begin(), ring.end());
        }
        CHECK(deviation(ring_radii(polygon(circle(2.6), 400)).value(), 2.6, 2.6, Vec2::Zero()).most < 1e-3);
    }

    TEST_CASE("where the edge goes back on itself its outermost place counts") {
        // along +x: out at 2, back at 2.25, out at 2.75
        const std::vector<Vec2> ring{{2.0, -2.0}, {2.0, 0.5}, {2.5, -0.5}, {3.0, 0.5}, {0.0, 3.0}, {-2.0, 0.0}};
        const std::vector<double> radii = ring_radii(ring).value();
        CHECK(radii[0] == doctest::Approx(2.75).epsilon(1e-7));
        CHECK(radii[32] == doctest::Approx(2.0).epsilon(1e-7));
    }

    TEST_CASE("a ring that does not go round the axis is refused") {
        CHECK(refusal(ring_radii(polygon(circle(1.0, Vec2(1.2, 0.0)), 40))) ==
              "the opening does not go round the axis");
        CHECK(refusal(ring_radii(polygon(circle(1.0, Vec2(0.9, 0.0)), 40))).empty());
    }

    TEST_CASE(
        "of what was torn: within an edge of the line everywhere, within a quarter of one in the root mean square") {
        for (const auto& [a, b, centre] : {std::tuple(2.6, 2.6, Vec2(0.0, 0.0)), std::tuple(2.9, 2.3, Vec2(0.3, -0.2)),
                                           std::tuple(2.0, 2.8, Vec2(-0.5, 0.1))}) {
            for (const int triangles : {1500, 9600}) {
                Cut cut(jittered_round(triangles));
                cut.cut_along(ellipse(a, b, centre));
                const Result<std::vector<double>> radii = opening_radii(cut.model, cut.state);
                REQUIRE(radii.ok());
                const Deviation off = deviation(radii.value(), a, b, centre);
                CAPTURE(cut.edge());
                CAPTURE(triangles);
                CHECK(off.most < cut.edge());
                CHECK(off.root_mean_square < 0.25 * cut.edge());
                cut.state.position[0] += Vec3(1.0, 0.0, 0.0);  // how it lies now does not matter
                CHECK(opening_radii(cut.model, cut.state).value() == radii.value());
            }
        }
    }

    TEST_CASE("what is no opening for a bag is refused, and why") {
        Cut cut(jittered_round(1500));
        CHECK(refusal(opening_radii(cut.model, cut.state)) == "the anterior capsule is not open");
        cut.cut_along(circle(2.6), pi);
        const std::string half = refusal(opening_radii(cut.model, cut.state));
        CHECK(half.starts_with("the opening is not closed: its tear has come round by 1"));
        CHECK(half.ends_with(" degrees"));

        Cut aside(jittered_round(2400));
        aside.cut_along(circle(1.2, Vec2(2.0, 0.0)));
        CHECK(refusal(opening_radii(aside.model, aside.state)) == "the opening does not go round the axis");

        Cut out(jittered_round(1500));
        out.cut_along(circle(2.6));
        REQUIRE(opening_radii(out.model, out.state).ok());
        out.notch_at(Vec2(2.6, 0.0), Vec2::UnitX());
        out.go_out(Vec2::UnitX(), 3.5);
        CHECK(opening_radii(out.model, out.state).ok());  // a slit that stays inside is not taken over
        out.model.springs.push_back({out.nearest_to(Vec2(3.2, 0.0)), Vec3(6.0, 0.0, 0.0), 1.0, 1.0});
        CHECK(refusal(opening_radii(out.model, out.state)) == "the tear has run out to the zonules");
        out.model.springs.clear();
        out.go_out(Vec2::UnitX(), 6.0);
        CHECK(refusal(opening_radii(out.model, out.state)) == "the tear has run out to the zonules");
    }
}
