// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of a bag for what lies within it and for what has left it through the opening.
#include <doctest/doctest.h>

#include <cmath>

#include "physics/contact/rigid_partner.hpp"

using namespace rhexis;

namespace {

BagModel bag() {
    BagModel model;
    model.shape = {4.5, 1.8, 2.6};
    model.opening_radius = 2.5;
    return model;
}

}  // namespace

TEST_SUITE("bag wall") {
    TEST_CASE("from within it pushes inwards, and nothing is in the opening") {
        const SurfaceDistance back = wall_distance(bag(), Vec3(0.0, 0.0, -2.5), {});
        CHECK(back.distance == doctest::Approx(0.1));
        CHECK(back.normal.z() == doctest::Approx(1.0));
        CHECK_FALSE(std::isfinite(wall_distance(bag(), Vec3(0.0, 0.0, 1.7), {}).distance));
    }

    TEST_CASE("what is beyond it is pushed back, from far away too unless the bag has a hole") {
        const Vec3 sunk(0.0, 0.0, -4.0);
        CHECK_FALSE(std::isfinite(wall_distance(bag(), sunk, {}).distance));
        const SurfaceDistance back = wall_distance(bag(), sunk, {.wall = HUGE_VAL});
        CHECK(back.distance == doctest::Approx(-1.4));
        CHECK(back.normal.z() == doctest::Approx(1.0));
    }

    TEST_CASE("what has left it lies on its front, and past its equator on the zonules") {
        const SurfaceDistance front = wall_distance(bag(), Vec3(3.5, 0.0, 1.6), {.outside = true});
        CHECK(front.distance > 0.0);
        CHECK(front.normal.x() > 0.0);
        for (const double z : {0.5, 0.05, -0.05}) {
            const SurfaceDistance beside = wall_distance(bag(), Vec3(5.5, 0.0, z), {.outside = true});
            CHECK(beside.distance == doctest::Approx(z));
            CHECK(beside.normal.z() == doctest::Approx(1.0));
        }
    }
}
