// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/marker_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "tracking/spots/outline.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// What of the rim's rays shows it, and where it is worn.
struct Rim {
    std::array<bool, outline_rays> shown{};
    Vec2 hidden = Vec2::Zero();  ///< sum of directions
    Vec2 worn = Vec2::Zero();
};

Rim rim_of(const TrueCamera& camera, const Scene& seen, int sphere, const Hiders& hiders, double middle_light,
           double least_light) {
    constexpr double near_rim = 0.93;
    constexpr double clearly_worn = 0.9;
    const Sphere& it = seen.spheres[at(sphere)];
    const double distance = it.centre.norm();
    const Vec3 towards = it.centre / distance;
    const Vec3 across = towards.unitOrthogonal();
    const Vec3 down = towards.cross(across);
    const double sine = near_rim * it.radius / distance;
    const double light = it.light * light_at_mm * light_at_mm / (distance * distance);
    const double whole = 1.0 - it.lobe * near_rim * near_rim;
    const Vec2 middle = it.centre.head<2>() / it.centre.z();
    const Mat2 slope = distortion_slope(camera.lens, middle);
    Rim rim;
    for (std::size_t i = 0; i < rim.shown.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / outline_rays;
        const Vec3 ray =
            std::sqrt(1.0 - sine * sine) * towards + sine * (std::cos(angle) * across + std::sin(angle) * down);
        const Shine shine_there = shine(seen, sphere, hiders, ray);
        const double left = shine_there.light / (light * whole);
        const Vec2 direction = (slope * (ray.head<2>() / ray.z() - middle)).normalized();
        rim.shown[i] = shine_there.share > 0.5 && left * whole * middle_light > least_light;
        if (!rim.shown[i]) {
            rim.hidden += direction;
        } else if (left < clearly_worn * shine_there.share) {
            rim.worn += direction;
        }
    }
    return rim;
}

}  // namespace

std::optional<MarkerOutline> marker_outline(const TrueCamera& camera, const Scene& seen, int sphere,
                                            const Hiders& hiders, double middle_light, const OutlineNoise& noise) {
    constexpr double fifth = 0.2 * outline_rays;
    constexpr double rim_width = 2.5;  // of a step that is blurred, in standard deviations of the blur
    const Rim rim = rim_of(camera, seen, sphere, hiders, middle_light, noise.least_light);
    const double spread = outline_spread(rim.shown, {});
    if (spread <= 0.0) {
        return std::nullopt;
    }
    const double rim_light = middle_light * (1.0 - seen.spheres[at(sphere)].lobe);
    const Sensor& sensor = camera.sensor;
    const double light_noise = std::sqrt(sensor.read_noise * sensor.read_noise + 0.5 * rim_light / sensor.electrons);
    const double slope = rim_light / (rim_width * camera.optics.psf_px);
    MarkerOutline result;
    result.sigma_px = std::hypot(noise.ray_px, noise.shot * light_noise / slope) * std::sqrt(spread);
    result.share = static_cast<double>(std::count(rim.shown.begin(), rim.shown.end(), true)) / outline_rays;
    result.shift = -noise.hidden_px / fifth * rim.hidden;
    if (rim.worn.norm() > 1.0) {
        // A rim that is nearly as bright as the rest is found where it is.
        const double wear = std::max(0.0, 0.8 - seen.spheres[at(sphere)].worn_left) / 0.5;
        const double moved = noise.worn_px * wear * wear * std::min(1.0, rim.worn.norm() / fifth);
        // In images it depends on how much of the patch's rim the fit leaves out: another way in each view.
        const double angle = 17.0 * (rim.worn.x() + 2.0 * rim.worn.y());
        result.shift += moved * Vec2(std::cos(angle), std::sin(angle));
    }
    return result;
}

}  // namespace rhexis::tracking::synthetic
