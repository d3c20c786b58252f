// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/debriefing/free_camera.hpp"

#include <algorithm>
#include <numbers>

namespace rhexis::station {
namespace {

constexpr double farthest_deg = 70.0;  ///< from the microscope: beyond, lids and brow are in the way
constexpr double least_zoom = 0.5;
constexpr double most_zoom = 6.0;
constexpr double radians = std::numbers::pi / 180.0;

}  // namespace

void FreeCamera::turn(double right_deg, double up_deg) {
    right_deg_ = std::clamp(right_deg_ + right_deg, -farthest_deg, farthest_deg);
    up_deg_ = std::clamp(up_deg_ + up_deg, -farthest_deg, farthest_deg);
}

void FreeCamera::zoom(double times) { zoom_ = std::clamp(zoom_ * times, least_zoom, most_zoom); }

Camera FreeCamera::of(const Camera& microscope) const {
    Camera camera = microscope;
    if (!is_free()) {
        return camera;
    }
    const Vec3 out = camera.eye - camera.target;
    const Vec3 right = camera.up.cross(out).normalized();
    const Quat turned = Quat(Eigen::AngleAxisd(right_deg_ * radians, camera.up.normalized())) *
                        Quat(Eigen::AngleAxisd(-up_deg_ * radians, right));
    camera.eye = camera.target + turned * out;
    camera.up = turned * camera.up;
    camera.field_mm /= zoom_;
    camera.stop_mm = 0.0;   // no eyepiece
    camera.aperture = 0.0;  // all is sharp: it is there to see, not to learn to focus
    return camera;
}

}  // namespace rhexis::station
