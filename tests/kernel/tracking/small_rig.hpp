// SPDX-License-Identifier: GPL-3.0-or-later
// Six cameras on a ring and two bodies, whose spots are where tracking's own camera model has them: what its steps are
// tested with one by one. How well they do with honest images, tests of the synthetic rig say.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "tracking/bodies/rigid_fit.hpp"
#include "tracking/rig.hpp"
#include "tracking/spot.hpp"

namespace rhexis::tracking::testing {

inline Rig small_rig(int cameras = 6) {
    Rig rig;
    rig.calibrated = true;
    for (int i = 0; i < cameras; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / cameras;
        Camera camera;
        camera.name = "camera " + std::to_string(i + 1);
        camera.width = 1280;
        camera.height = 1024;
        camera.lens = {1667.0, 1667.0, 639.5, 511.5, -0.1, 0.05, 2e-4, -1e-4, 0.0};
        camera.pose.position = {340.0 * std::cos(turn), 340.0 * std::sin(turn), 290.0};
        camera.pose.orientation = turn_of_z(-camera.pose.position);
        rig.cameras.push_back(camera);
    }
    return rig;
}

inline std::vector<MarkerBody> small_bodies() {
    MarkerBody phaco;
    phaco.name = "phaco";
    phaco.markers = {{-21, -9, -4}, {24, -12, 3}, {-3, 26, -6}, {0, -5, 30}};
    phaco.tip.position = {0, 0, -100};
    MarkerBody head;
    head.name = "head";
    head.markers = {{-35, -20, 2}, {37, -14, -3}, {-9, 31, 5}, {7, 3, 27}};
    return {phaco, head};
}

/// Spots of bodies at these poses, with this much noise on their centres; of each body in each camera in the order of
/// its markers.
inline std::vector<CameraSpots> spots_of(const Rig& rig, const std::vector<MarkerBody>& bodies,
                                         const std::vector<Pose>& poses, double time_s, double noise_px, Rng& rng) {
    std::vector<CameraSpots> all;
    for (std::size_t c = 0; c < rig.cameras.size(); ++c) {
        CameraSpots exposure{static_cast<int>(c), time_s, {}};
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            for (const Vec3& marker : bodies[b].markers) {
                const Camera& camera = rig.cameras[c];
                const Vec3 seen = camera.pose.to_body(poses[b].to_world(marker));
                Spot spot;
                spot.at = sphere_image(camera.lens, seen, bodies[b].radius_mm) + noise_px * normal2(rng);
                spot.area = sphere_area(camera.lens, seen, bodies[b].radius_mm);
                spot.peak = 200.0;
                exposure.spots.push_back(spot);
            }
        }
        all.push_back(exposure);
    }
    return all;
}

inline Pose pose_of(const Vec3& position, const Vec3& rotation) {
    return moved({position, Quat::Identity()}, {Vec3::Zero(), rotation}, 1.0);
}

inline double turn_between(const Quat& one, const Quat& other) { return one.angularDistance(other); }

}  // namespace rhexis::tracking::testing
