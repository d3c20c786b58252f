// SPDX-License-Identifier: GPL-3.0-or-later
// A body's pose from all images of its markers at once: cameras weigh as they should, and a marker that one camera
// alone sees helps.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/camera.hpp"
#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

/// How a body moves: of its origin [mm/s], and about it [rad/s], in the rig's axes.
struct Motion {
    Vec3 velocity = Vec3::Zero();
    Vec3 turning = Vec3::Zero();
};

/// The pose `ahead_s` later, if it goes on so.
Pose moved(const Pose& pose, const Motion& motion, double ahead_s);

/// An image of a marker.
struct Sighting {
    int camera = 0;
    int marker = 0;
    int spot = 0;            ///< index among that camera's spots
    Vec2 at = Vec2::Zero();  ///< [pixels]
    double sigma_px = 0.05;  ///< of `at`, each way
    double later_s = 0.0;    ///< than the time that the pose is of
};

struct FitSettings {
    int most_steps = 10;
    double outlier_sigmas = 4.0;  ///< a sighting farther off has ever less weight [Beaton1974]
    double floor_px = 0.02;       ///< least sigma: what calibration leaves
};

struct Fit {
    Pose pose{};
    double residual_px = 0.0;  ///< root mean square of sightings that count
    int counted = 0;           ///< sightings with at least a tenth of their weight
    int markers = 0;           ///< of those sightings
    int cameras = 0;
    Eigen::Matrix<double, 6, 6> covariance =
        Eigen::Matrix<double, 6, 6>::Zero();  ///< of shift [mm] and turn [rad] in the rig
    std::vector<double> weights{};            ///< by sighting, 0 to 1
    std::vector<Vec2> offs{};                 ///< by sighting, from where the pose has it [pixels]
};

/// Centre of the image of a sphere: of an ellipse, which is not where its centre's image is. Before the camera.
Vec2 sphere_image(const Lens& lens, const Vec3& in_camera, double radius_mm);

/// Area of that image [pixels].
double sphere_area(const Lens& lens, const Vec3& in_camera, double radius_mm);

/// From `begun`, by Gauss-Newton steps with weights that fall with the residual. None: fewer than three markers' worth
/// of sightings that agree, or they do not determine it.
std::optional<Fit> fit_body(std::span<const Camera> cameras, const MarkerBody& body,
                            std::span<const Sighting> sightings, const Pose& begun, const Motion& motion,
                            const FitSettings& settings);

}  // namespace rhexis::tracking
