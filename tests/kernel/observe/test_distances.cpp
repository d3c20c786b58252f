// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "observe/distances.hpp"

using namespace rhexis;

namespace {

/// Least distance to densely sampled points of the posterior half: an independent, slow way.
double sampled_posterior(const BagShape& shape, const Vec3& point) {
    double least = 1e9;
    const double angle = std::atan2(point.y(), point.x());
    for (int i = 0; i <= 20000; ++i) {
        const double t = 1.5707963267948966 * i / 20000.0;
        const double r = shape.radius * std::cos(t);
        const Vec3 on(r * std::cos(angle), r * std::sin(angle), -shape.posterior * std::sin(t));
        least = std::min(least, (on - point).norm());
    }
    return least;
}

}  // namespace

TEST_SUITE("distances") {
    TEST_CASE("distance to the posterior capsule equals that to a dense sampling of it") {
        const BagShape shape;
        Rng rng(3, "points");
        for (int i = 0; i < 40; ++i) {
            const Vec3 point = uniform3(rng).cwiseProduct(Vec3(8.0, 8.0, 5.0)) - Vec3(4.0, 4.0, 3.0);
            CHECK(posterior_distance(shape, point) == doctest::Approx(sampled_posterior(shape, point)).epsilon(1e-5));
        }
    }

    TEST_CASE("the anterior opening is no wall and its rim is") {
        BagModel bag;
        bag.opening_radius = 2.5;
        const Vec3 in_opening(0.0, 0.0, bag.shape.anterior);
        CHECK(bag_wall_distance(bag, in_opening) > 2.0);
        const double share = bag.opening_radius / bag.shape.radius;
        const double rim_z = bag.shape.anterior * std::sqrt(1.0 - share * share);
        CHECK(bag_wall_distance(bag, Vec3(2.5, 0.0, rim_z)) == doctest::Approx(0.0).epsilon(1e-9));
        CHECK(bag_wall_distance(bag, Vec3(0.0, 0.0, -bag.shape.posterior)) == doctest::Approx(0.0).epsilon(1e-9));
    }

    TEST_CASE("a rod over the iris is as far from it as its nearest point less its radius") {
        EyeAnatomy eye;
        eye.iris_z = 3.0;
        ToolModel rod;
        rod.parts = {{Vec3::Zero(), Vec3(0.0, 0.0, 10.0), 0.3, 0.5}};
        const auto iris = [&](const Vec3& point) { return iris_distance(eye, point); };
        Pose pose;
        pose.position = Vec3(0.0, 0.0, 2.0);  // through the pupil, upright
        const double sideways = eye.pupil_radius;
        // The cone widens upwards: nearest at the iris's upper face, radius 0.3 + 0.02 z above the tip.
        const double expected = sideways - (0.3 + 0.02 * (3.0 + 0.5 * eye.iris_thickness - 2.0));
        CHECK(tool_gap(rod, pose, iris) == doctest::Approx(expected).epsilon(2e-3));
        pose.position = Vec3(0.5 * (eye.pupil_radius + eye.limbus_radius), 0.0, 4.0);
        CHECK(tool_gap(rod, pose, iris) == doctest::Approx(1.0 - 0.5 * eye.iris_thickness - 0.3).epsilon(1e-6));
    }
}
