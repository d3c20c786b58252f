// SPDX-License-Identifier: GPL-3.0-or-later
// Six cameras that see a body of four markers; one of them is bumped.
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "tracking/calibration/drift_watch.hpp"
#include "tracking/camera.hpp"

namespace rhexis::tracking {
namespace {

constexpr double rate_hz = 120.0;

std::vector<Camera> six_cameras() {
    std::vector<Camera> cameras;
    for (int i = 0; i < 6; ++i) {
        const double angle = 1.0472 * i;
        Camera camera;
        camera.lens = {1667.0, 1667.0, 640.0, 512.0, 0, 0, 0, 0, 0};
        camera.pose.position = Vec3(290.0 * std::cos(angle), 290.0 * std::sin(angle), 344.0);
        camera.pose.orientation = turn_of_z(-camera.pose.position);
        cameras.push_back(camera);
    }
    return cameras;
}

/// Of the rays of all cameras but one.
Vec3 point_without(const std::vector<Camera>& cameras, const std::vector<Vec2>& seen, std::size_t without) {
    Mat3 across = Mat3::Zero();
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (i != without) {
            const Ray ray = ray_of(cameras[i], seen[i]);
            const Mat3 plane = Mat3::Identity() - ray.along * ray.along.transpose();
            across += plane;
            moment += plane * ray.from;
        }
    }
    return across.inverse() * moment;
}

struct Scene {
    std::vector<Camera> known = six_cameras();
    std::vector<Camera> real = six_cameras();
    double occluded = 0.0;  ///< share of exposures in which camera 5 sees a half-hidden sphere
    double noise_px = 0.05;
};

std::vector<CameraResidual> residuals_of(const Scene& scene, double time_s, Rng& rng) {
    const std::vector<Vec3> body{{0, 0, 0}, {20, 0, 0}, {0, 26, 5}, {-14, 3, 28}};
    std::vector<CameraResidual> residuals(6);
    const bool hidden = rng.uniform() < scene.occluded;
    for (const Vec3& marker : body) {
        const Vec3 point = marker + 20.0 * Vec3(std::sin(time_s), std::cos(1.3 * time_s), std::sin(0.7 * time_s));
        std::vector<Vec2> seen;
        for (const Camera& camera : scene.real) {
            seen.emplace_back(*project(camera, point) + scene.noise_px * normal2(rng));
        }
        if (hidden) {
            seen[4] += Vec2(4.6, 0.0);
        }
        for (std::size_t i = 0; i < 6; ++i) {
            const Vec2 predicted = *project(scene.known[i], point_without(scene.known, seen, i));
            residuals[i].mean_px += (seen[i] - predicted) / 4.0;
            ++residuals[i].count;
        }
    }
    return residuals;
}

/// Seconds until a drift is told, and which; none within the time given.
struct Told {
    double after_s = -1.0;
    Drift drift{};
};

Told watched(const Scene& scene, double from_s, double until_s, DriftState& state, Rng& rng) {
    const DriftWatch watch;
    for (double time = from_s; time < until_s; time += 1.0 / rate_hz) {
        watch.add(state, time, residuals_of(scene, time, rng));
        if (const std::optional<Drift> drift = watch.drift(state)) {
            return {time - from_s, *drift};
        }
    }
    return {};
}

void turn_camera(Camera& camera, double degrees, const Vec3& axis) {
    camera.pose.orientation = camera.pose.orientation * Quat(Eigen::AngleAxisd(degrees / 57.29578, axis));
}

}  // namespace

TEST_CASE("whichever camera is turned by a tenth of a degree is named within a second") {
    for (std::size_t bumped = 0; bumped < 6; ++bumped) {
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
            Scene scene;
            Rng rng(7, "bump");
            DriftState state;
            CHECK(watched(scene, 0.0, 2.0, state, rng).after_s < 0.0);
            turn_camera(scene.real[bumped], 0.1, axis);
            const Told told = watched(scene, 2.0, 4.0, state, rng);
            CHECK(told.after_s >= 0.0);
            CHECK(told.after_s < 1.0);
            // Let the window fill with what is so now before asking whether others are off as well.
            const DriftWatch watch;
            for (double time = 4.0; time < 5.0; time += 1.0 / rate_hz) {
                watch.add(state, time, residuals_of(scene, time, rng));
            }
            const std::optional<Drift> drift = watch.drift(state);
            REQUIRE(drift.has_value());
            CHECK(drift->camera == static_cast<int>(bumped));
            CHECK(drift->alone);
            CHECK(told.drift.camera == static_cast<int>(bumped));
        }
    }
}

TEST_CASE("cameras at rest are never named, for a minute") {
    Rng rng(8, "rest");
    DriftState state;
    CHECK(watched(Scene{}, 0.0, 60.0, state, rng).after_s < 0.0);
}

TEST_CASE("a sphere that is half hidden now and then does not make a camera drift") {
    Scene scene;
    scene.occluded = 0.3;
    Rng rng(9, "hidden");
    DriftState state;
    CHECK(watched(scene, 0.0, 10.0, state, rng).after_s < 0.0);
    scene.occluded = 0.9;  // what is hidden nearly always cannot be told from a bump
    CHECK(watched(scene, 10.0, 12.0, state, rng).drift.camera == 4);
}

TEST_CASE("two cameras that are bumped alike are not one that moved alone") {
    Scene scene;
    turn_camera(scene.real[0], 0.1, Vec3::UnitX());
    turn_camera(scene.real[3], 0.1, Vec3::UnitX());
    Rng rng(10, "two");
    DriftState state;
    const Told told = watched(scene, 0.0, 2.0, state, rng);
    REQUIRE(told.after_s >= 0.0);
    CHECK_FALSE(told.drift.alone);
}

TEST_CASE("what was seen too seldom, or long ago, tells nothing") {
    const DriftWatch watch;
    DriftState state;
    for (int i = 0; i < 29; ++i) {
        watch.add(state, i / rate_hz, std::vector<CameraResidual>{{Vec2(9, 9), 1}, {Vec2(9, 9), 0}});
    }
    CHECK_FALSE(watch.drift(state).has_value());
    watch.add(state, 29 / rate_hz, std::vector<CameraResidual>{{Vec2(9, 9), 1}, {Vec2(9, 9), 0}});
    REQUIRE(watch.drift(state).has_value());
    CHECK(watch.drift(state)->camera == 0);
    watch.add(state, 5.0, std::vector<CameraResidual>{{Vec2(0, 0), 0}, {Vec2(0, 0), 0}});
    CHECK_FALSE(watch.drift(state).has_value());
}

}  // namespace rhexis::tracking
