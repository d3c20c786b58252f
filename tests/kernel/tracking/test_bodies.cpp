// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "math/random_vectors.hpp"
#include "small_rig.hpp"
#include "tracking/bodies/identity.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

const Pose somewhere = pose_of({12, -7, 20}, {0.3, -0.5, 0.9});

std::vector<Vec3> points_of(const MarkerBody& body, const Pose& pose) {
    std::vector<Vec3> points;
    for (const Vec3& marker : body.markers) {
        points.push_back(pose.to_world(marker));
    }
    return points;
}

std::vector<Sighting> sightings(const Rig& rig, const MarkerBody& body, const Pose& pose, double noise_px, Rng& rng) {
    std::vector<Sighting> all;
    for (const CameraSpots& exposure : spots_of(rig, {body}, {pose}, 0.0, noise_px, rng)) {
        for (int m = 0; m < static_cast<int>(exposure.spots.size()); ++m) {
            all.push_back({exposure.camera, m, m, exposure.spots[static_cast<std::size_t>(m)].at, 0.05, 0.0});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("a body is found among the points of another and stray ones, marker by marker") {
    const std::vector<MarkerBody> bodies = small_bodies();
    std::vector<Vec3> points = points_of(bodies[1], pose_of({-30, 40, 0}, {0, 0.2, 0}));
    points.emplace_back(3, 3, 3);
    for (const Vec3& point : points_of(bodies[0], somewhere)) {
        points.insert(points.begin(), point);
    }
    const std::optional<Identified> found = identify(bodies[0], points, std::vector<bool>(points.size(), false), 0.3);
    REQUIRE(found.has_value());
    CHECK(found->points == std::vector<int>{3, 2, 1, 0});
    CHECK((found->pose.position - somewhere.position).norm() < 1e-9);
    CHECK(turn_between(found->pose.orientation, somewhere.orientation) < 1e-7);
    std::vector<bool> taken(points.size(), false);
    taken[1] = true;
    taken[2] = true;
    CHECK_FALSE(identify(bodies[0], points, taken, 0.3).has_value());
}

TEST_CASE("three of four markers are enough, two are not, and a mirrored body is not the body") {
    const MarkerBody body = small_bodies()[0];
    std::vector<Vec3> points = points_of(body, somewhere);
    points.pop_back();
    std::optional<Identified> found = identify(body, points, {false, false, false}, 0.3);
    REQUIRE(found.has_value());
    CHECK(found->markers == 3);
    CHECK(found->points[3] == -1);
    CHECK((found->pose.position - somewhere.position).norm() < 1e-9);
    points.pop_back();
    CHECK_FALSE(identify(body, points, {false, false}, 0.3).has_value());
    MarkerBody mirrored = body;
    for (Vec3& marker : mirrored.markers) {
        marker.x() = -marker.x();
    }
    points = points_of(mirrored, somewhere);
    found = identify(body, points, {false, false, false, false}, 0.3);
    // Three points are a rigid body's either way; all four are not.
    CHECK((!found || found->markers == 3));
}

TEST_CASE("points with an error are fitted with the least sum of squares") {
    const MarkerBody body = small_bodies()[0];
    std::vector<Vec3> points = points_of(body, somewhere);
    Rng rng(9);
    for (Vec3& point : points) {
        point += 0.1 * normal3(rng);
    }
    const auto squares = [&](const Pose& pose) {
        double sum = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            sum += (pose.to_world(body.markers[i]) - points[i]).squaredNorm();
        }
        return sum;
    };
    const Pose best = fitted(body.markers, points);
    for (int i = 0; i < 6; ++i) {
        for (const double step : {-1e-3, 1e-3}) {
            Motion motion;
            (i < 3 ? motion.velocity : motion.turning)[i % 3] = step;
            CHECK(squares(moved(best, motion, 1.0)) > squares(best));
        }
    }
}

TEST_CASE("a sphere's image is the ellipse that its outline projects to") {
    const Lens lens{1667, 1667, 640, 512, 0, 0, 0, 0, 0};
    const Vec3 centre(150, 60, 430);
    constexpr double radius = 3.0;
    // The outline: points of the sphere whose lines of sight touch it.
    const Vec3 along = centre.normalized();
    const double to_ring = centre.norm() - radius * radius / centre.norm();
    const double ring = radius * std::sqrt(1.0 - std::pow(radius / centre.norm(), 2));
    const Vec3 right = along.unitOrthogonal();
    const Vec3 down = along.cross(right);
    double twice_area = 0.0;
    Vec2 moment = Vec2::Zero();
    constexpr int count = 2000;
    const auto image = [&](int i) {
        const double turn = 2.0 * std::numbers::pi * i / count;
        const Vec3 point = to_ring * along + ring * (std::cos(turn) * right + std::sin(turn) * down);
        return Vec2(lens.fx * point.x() / point.z(), lens.fy * point.y() / point.z());
    };
    for (int i = 0; i < count; ++i) {
        const Vec2 a = image(i);
        const Vec2 b = image(i + 1);
        const double part = a.x() * b.y() - a.y() * b.x();
        twice_area += part;
        moment += part * (a + b) / 3.0;
    }
    const Vec2 middle = moment / twice_area + Vec2(lens.cx, lens.cy);
    CHECK((sphere_image(lens, centre, radius) - middle).norm() < 1e-4);
    CHECK((distorted(lens, centre.head<2>() / centre.z()) - middle).norm() > 0.02);
    CHECK(sphere_area(lens, centre, radius) == doctest::Approx(0.5 * std::abs(twice_area)).epsilon(0.002));
}

TEST_CASE("a pose is found from its images, from a start that is millimetres off") {
    const Rig rig = small_rig();
    const MarkerBody body = small_bodies()[0];
    Rng rng(10);
    const std::vector<Sighting> exact = sightings(rig, body, somewhere, 0.0, rng);
    const Pose begun = moved(somewhere, {{2, -1, 1.5}, {0.02, -0.03, 0.01}}, 1.0);
    const std::optional<Fit> fit = fit_body(rig.cameras, body, exact, begun, {}, {});
    REQUIRE(fit.has_value());
    CHECK((fit->pose.position - somewhere.position).norm() < 1e-5);
    CHECK(turn_between(fit->pose.orientation, somewhere.orientation) < 1e-6);
    CHECK(fit->counted == 24);
    CHECK(fit->cameras == 6);
    CHECK(fit->markers == 4);
}

TEST_CASE("how sure a pose is, is how much it scatters") {
    const Rig rig = small_rig();
    const MarkerBody body = small_bodies()[0];
    FitSettings settings;
    settings.floor_px = 0.0;
    settings.outlier_sigmas = 50.0;  // noise is normal here: nothing is to be left out
    Rng rng(11);
    Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
    Vec6 squares = Vec6::Zero();
    constexpr int count = 400;
    for (int i = 0; i < count; ++i) {
        const std::vector<Sighting> noisy = sightings(rig, body, somewhere, 0.05, rng);
        const std::optional<Fit> fit = fit_body(rig.cameras, body, noisy, somewhere, {}, settings);
        REQUIRE(fit.has_value());
        const Eigen::AngleAxisd turn(fit->pose.orientation * somewhere.orientation.conjugate());
        Vec6 off;
        off << fit->pose.position - somewhere.position, turn.angle() * turn.axis();
        squares += off.cwiseAbs2();
        expected = fit->covariance;
    }
    for (int i = 0; i < 6; ++i) {
        CHECK(std::sqrt(squares[i] / count) == doctest::Approx(std::sqrt(expected(i, i))).epsilon(0.12));
    }
}

TEST_CASE("a spot that is another's does not move the pose, and a marker that one camera alone sees helps") {
    const Rig rig = small_rig();
    const MarkerBody body = small_bodies()[0];
    Rng rng(12);
    std::vector<Sighting> seen = sightings(rig, body, somewhere, 0.0, rng);
    seen[5].at += Vec2(6.0, -4.0);
    seen[14].at += Vec2(-1.0, 0.5);
    const std::optional<Fit> fit = fit_body(rig.cameras, body, seen, somewhere, {}, {});
    REQUIRE(fit.has_value());
    CHECK((fit->pose.position - somewhere.position).norm() < 1e-4);
    CHECK(fit->weights[5] == 0.0);
    CHECK(fit->weights[14] == 0.0);
    CHECK(fit->counted == 22);
    std::vector<Sighting> few;
    for (const Sighting& one : sightings(rig, body, somewhere, 0.0, rng)) {
        if (one.camera < 2 && one.marker < 2) {
            few.push_back(one);
        }
    }
    CHECK_FALSE(fit_body(rig.cameras, body, few, somewhere, {}, {}).has_value());
    few.push_back(sightings(rig, body, somewhere, 0.0, rng)[2]);
    CHECK(fit_body(rig.cameras, body, few, somewhere, {}, {}).has_value());
}

TEST_CASE("exposures at other times are taken where the body was then") {
    const Rig rig = small_rig();
    const MarkerBody body = small_bodies()[0];
    Rng rng(13);
    const Motion motion{{100, -50, 20}, {0.5, 0, -1}};
    std::vector<Sighting> all;
    for (int c = 0; c < 6; ++c) {
        const double later_s = 0.001 * (c - 2);
        for (Sighting one : sightings(rig, body, moved(somewhere, motion, later_s), 0.0, rng)) {
            if (one.camera == c) {
                one.later_s = later_s;
                all.push_back(one);
            }
        }
    }
    const std::optional<Fit> fit = fit_body(rig.cameras, body, all, somewhere, motion, {});
    REQUIRE(fit.has_value());
    CHECK((fit->pose.position - somewhere.position).norm() < 1e-4);
    const std::optional<Fit> without = fit_body(rig.cameras, body, all, somewhere, {}, {});
    CHECK((!without || (without->pose.position - somewhere.position).norm() > 0.01));
}

}  // namespace rhexis::tracking
