// SPDX-License-Identifier: GPL-3.0-or-later
// A camera as tracking takes it to be: a pinhole with Brown's distortion, at its place in the rig.
#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

/// [Brown1971]: x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), y' with p1 and p2 exchanged; the
/// order of OpenCV's k1 k2 p1 p2 k3. A pixel's centre has whole coordinates, the first one's are (0, 0).
struct Lens {
    double fx = 0.0;  ///< [pixels]
    double fy = 0.0;
    double cx = 0.0;  ///< [pixels]
    double cy = 0.0;
    double k1 = 0.0;
    double k2 = 0.0;
    double p1 = 0.0;
    double p2 = 0.0;
    double k3 = 0.0;
};

struct Camera {
    std::string name{};  ///< what is said of it, and the folder or device that its images come from
    int width = 0;       ///< [pixels]
    int height = 0;
    Lens lens{};
    Pose pose{};  ///< in the rig [mm]; the camera's +z looks out, +x is right and +y down in its image
};

/// Where the image of a direction lies, (x, y) = (X/Z, Y/Z) in the camera's frame [pixels].
Vec2 distorted(const Lens& lens, const Vec2& direction);

/// The direction of a pixel: distorted() the other way round, by Newton steps, to 1e-9. Far outside the image, where
/// the model folds over, the nearest that was found.
Vec2 undistorted(const Lens& lens, const Vec2& pixel);

/// The image of a point of the rig [pixels]; none: it is behind the camera. It may lie outside the image.
std::optional<Vec2> project(const Camera& camera, const Vec3& point);

/// How the image of a point of the camera's frame moves with the point, the lens's distortion in it: d pixel / d
/// point [pixels/mm]. The point lies before the camera.
Eigen::Matrix<double, 2, 3> projection_slope(const Lens& lens, const Vec3& in_camera);

/// Ray of a pixel, in the rig: it begins at the camera; unit direction.
struct Ray {
    Vec3 from = Vec3::Zero();
    Vec3 along = Vec3::UnitZ();
};
Ray ray_of(const Camera& camera, const Vec2& pixel);

}  // namespace rhexis::tracking
