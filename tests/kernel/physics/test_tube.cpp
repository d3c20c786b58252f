// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <cmath>

#include "base/rng.hpp"
#include "flow/tube.hpp"

using namespace rhexis;

namespace {

/// Bore 1 mm in radius, wall 0.3 mm, from z = 0 to 5.
TubeModel straight() {
    TubeModel tube;
    tube.stations = {{0.0, 1.0, 1.0}, {5.0, 1.0, 1.0}};
    tube.lip = 0.15;
    return tube;
}

double uniform(Rng& rng, double low, double high) { return low + (high - low) * rng.uniform(); }

}  // namespace

TEST_SUITE("tube") {
    TEST_CASE("a round tube: exact in its bore, before its end and beside it") {
        const TubeModel tube = straight();
        CHECK(tube_distance(tube, {0.6, 0.0, 2.0}).distance == doctest::Approx(0.4));
        CHECK(tube_distance(tube, {0.0, 1.1, 2.0}).distance == doctest::Approx(-0.1));
        CHECK(tube_distance(tube, {0.0, 1.25, 2.0}).distance == doctest::Approx(-0.05));
        CHECK(tube_distance(tube, {0.0, -1.5, 2.0}).distance == doctest::Approx(0.2));
        CHECK(tube_distance(tube, {0.0, -1.5, 2.0}).normal.isApprox(-Vec3::UnitY()));
        CHECK(tube_distance(tube, {1.15, 0.0, 5.2}).distance == doctest::Approx(0.2));
        CHECK(tube_distance(tube, {1.15, 0.0, 5.2}).normal.isApprox(Vec3::UnitZ()));
        CHECK(tube_distance(tube, {1.55, 0.0, 5.15}).distance == doctest::Approx(0.5 - 0.15));
    }

    TEST_CASE("no place where the distance jumps: two points differ by no more than what is between them") {
        TubeModel tube = straight();
        double steepest = 1.0 + 1e-9;
        SUBCASE("round") {}
        SUBCASE("a funnel that ends in an ellipse") {
            tube.stations = {{0.0, 1.4, 1.4}, {3.0, 1.3, 0.9}, {5.0, 1.3, 0.9}};
            steepest = 1.6;  // the distance across the axis is not the nearest
        }
        Rng rng(7);
        for (int i = 0; i < 20000; ++i) {
            const Vec3 a(uniform(rng, 0.3, 1.7), uniform(rng, -1.7, 1.7), uniform(rng, 2.0, 5.6));
            const Vec3 b = a + 1e-3 * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
            const double change = std::abs(tube_distance(tube, a).distance - tube_distance(tube, b).distance);
            CHECK(change <= steepest * (a - b).norm() + 1e-12);
        }
    }

    TEST_CASE("the normal is the gradient, but on the middle of the wall") {
        const TubeModel tube = straight();
        Rng rng(8);
        int looked_at = 0;
        for (int i = 0; i < 500; ++i) {
            const Vec3 p(uniform(rng, 0.3, 1.7), uniform(rng, -1.7, 1.7), uniform(rng, 4.0, 5.6));
            if (std::abs(p.head<2>().norm() - 1.15) < 1e-3 || std::abs(p.z() - 4.85) < 1e-3) {
                continue;
            }
            ++looked_at;
            const SurfaceDistance here = tube_distance(tube, p);
            for (int k = 0; k < 3; ++k) {
                const Vec3 h = 1e-6 * Vec3::Unit(k);
                const double slope = (tube_distance(tube, p + h).distance - tube_distance(tube, p - h).distance) / 2e-6;
                CHECK(std::abs(slope - here.normal[k]) < 1e-5);
            }
        }
        CHECK(looked_at > 400);
    }
}
