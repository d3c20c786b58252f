// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/half_ellipsoids.hpp"

using namespace rhexis;

namespace {

/// Distance to the profile by search over the angle along it, refined around the best sample.
double searched_distance(const HalfEllipsoids& shape, const Vec3& p) {
    const double rho = p.head<2>().norm();
    const auto distance_at = [&shape, &p, rho](double angle) {
        const double c = std::sin(angle) >= 0.0 ? shape.anterior : shape.posterior;
        return std::hypot(rho - shape.radius * std::cos(angle), p.z() - c * std::sin(angle));
    };
    double width = std::numbers::pi / 1000;
    double best = 0.0;
    for (int i = -500; i <= 500; ++i) {
        best = distance_at(i * width) < distance_at(best) ? i * width : best;
    }
    for (; width > 1e-13; width *= 0.6) {
        for (double trial : {best - width, best + width}) {
            best = distance_at(trial) < distance_at(best) ? trial : best;
        }
    }
    return distance_at(best);
}

}  // namespace

TEST_SUITE("mesh") {
    TEST_CASE("the distance to two half-ellipsoids agrees with a search over their profile") {
        Rng rng(3);
        for (const HalfEllipsoids& shape : {HalfEllipsoids{4.8, 1.95, 2.8}, HalfEllipsoids{2.0, 3.0, 2.0}}) {
            const double sharpest = std::pow(std::min(shape.anterior, shape.posterior), 2) / shape.radius;
            int checked = 0;
            for (int i = 0; i < 2000; ++i) {
                const Vec3 p = uniform3(rng).cwiseProduct(Vec3(12, 12, 10)) - Vec3(6, 6, 5);
                const SurfacePoint closest = closest_on(shape, p);
                if (closest.distance > -0.8 * sharpest) {
                    ++checked;
                    const double sign = surface_level(shape, p) < 1.0 ? -1.0 : 1.0;
                    CHECK(std::abs(closest.distance - sign * searched_distance(shape, p)) < 1e-9);
                    CHECK(std::abs(surface_level(shape, p - closest.distance * closest.normal) - 1.0) < 1e-12);
                    CHECK(closest.normal.norm() == doctest::Approx(1.0).epsilon(1e-14));
                }
            }
            CHECK(checked > 1000);
        }
    }

    TEST_CASE("distance and normal are smooth across the equator") {
        const HalfEllipsoids shape{4.8, 1.95, 2.8};
        for (double offset : {-0.5, -0.05, 0.0, 0.05, 1.0}) {
            const Vec3 at(4.8 + offset, 0.0, 0.0);
            const SurfacePoint above = closest_on(shape, at + Vec3(0, 0, 1e-9));
            const SurfacePoint below = closest_on(shape, at - Vec3(0, 0, 1e-9));
            CHECK(above.distance == doctest::Approx(offset).epsilon(1e-9));
            CHECK(std::abs(above.distance - below.distance) < 1e-15);
            CHECK((above.normal - below.normal).norm() < 1e-8);
        }
    }

    TEST_CASE("points on the axis, on the equatorial plane and at the centre have a distance") {
        const HalfEllipsoids shape{4.8, 1.95, 2.8};
        CHECK(closest_on(shape, Vec3(0, 0, 2.95)).distance == doctest::Approx(1.0).epsilon(1e-14));
        CHECK(closest_on(shape, Vec3(0, 0, -2.3)).distance == doctest::Approx(-0.5).epsilon(1e-14));
        CHECK(closest_on(shape, Vec3(0, 0, -2.3)).normal.z() == doctest::Approx(-1.0));
        CHECK(closest_on(shape, Vec3::Zero()).distance == doctest::Approx(-1.95).epsilon(1e-14));
        CHECK(closest_on(shape, Vec3(5.8, 0, 0)).distance == doctest::Approx(1.0).epsilon(1e-14));
        const HalfEllipsoids unit{1.0, 1.0, 1.0};
        CHECK(closest_on(unit, Vec3::Zero()).distance == doctest::Approx(-1.0));
        CHECK(closest_on(unit, Vec3(0.3, 0.2, 0.1)).distance ==
              doctest::Approx(Vec3(0.3, 0.2, 0.1).norm() - 1.0).epsilon(1e-13));
    }

    TEST_CASE("the distance keeps its relative precision close to the surface") {
        const HalfEllipsoids shape{4.8, 1.95, 2.8};
        const Vec3 on = onto_surface(shape, Vec3(1.0, 2.0, 1.3));
        const Vec3 normal = closest_on(shape, on).normal;
        for (double offset : {-1e-3, -1e-6, 1e-6, 1e-3}) {
            CHECK(closest_on(shape, on + offset * normal).distance == doctest::Approx(offset).epsilon(1e-8));
        }
    }
}
