// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/spot_errors.hpp"

#include "base/index.hpp"
#include "tracking/synthetic/marker_spots.hpp"

namespace rhexis::tracking {
namespace {

/// A sphere as a true camera has it before it, and how fast it goes there.
struct SphereSeen {
    synthetic::Sphere sphere{};
    Vec2 image = Vec2::Zero();  ///< [pixels]
    double area = 0.0;
    double smear_px = 0.0;
};

std::optional<SphereSeen> sphere_seen(const synthetic::TrueCamera& camera, const Camera& without_prism,
                                      const synthetic::Sphere& in_rig, const Vec3& velocity, double exposure_s) {
    SphereSeen seen;
    seen.sphere = in_rig;
    seen.sphere.centre = camera.pose.to_body(in_rig.centre);
    if (seen.sphere.centre.z() <= 4.0 * in_rig.radius) {
        return std::nullopt;
    }
    seen.image = distorted(camera.lens, synthetic::outline(seen.sphere).centre);
    if (!(seen.image.x() > 0.0 && seen.image.y() > 0.0 && seen.image.x() < camera.width - 1 &&
          seen.image.y() < camera.height - 1)) {
        return std::nullopt;
    }
    seen.area = sphere_area(without_prism.lens, seen.sphere.centre, in_rig.radius);
    seen.smear_px = velocity.norm() * exposure_s * camera.lens.fx / seen.sphere.centre.z();
    return seen;
}

void sight(const SphereSeen& sphere, const std::vector<Spot>& spots, const TrackerSettings& settings,
           SightedSphere& result) {
    constexpr double near_px = 3.0;
    double least_px = near_px;
    for (const Spot& spot : spots) {
        const Vec2 off = spot.at - sphere.image;
        if (off.norm() < least_px) {
            least_px = off.norm();
            result.off = off;
            result.sigma_px = believed_sigma(spot, sphere.area, sphere.smear_px, settings);
            result.sighted = result.sigma_px > 0.0 ? Sighted::believed : Sighted::refused;
        }
    }
}

}  // namespace

std::vector<SightedSphere> sighted_spheres(const synthetic::SyntheticRig& rig, const synthetic::Clip& clip,
                                           const std::vector<std::vector<CameraSpots>>& recorded,
                                           const TrackerSettings& settings) {
    constexpr double soon_s = 1e-3;
    const Rig without_prism = synthetic::without_prism(rig);
    std::vector<SightedSphere> result;
    synthetic::Scene scene;
    synthetic::Scene soon;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        for (const CameraSpots& exposure : recorded[i]) {
            scene_at(clip, exposure.time_s, scene);
            scene_at(clip, exposure.time_s + soon_s, soon);
            const synthetic::TrueCamera camera = camera_at(clip, rig, exposure.camera, exposure.time_s);
            std::size_t sphere = 0;  // body by body, in the order of their markers
            for (std::size_t body = 0; body < clip.bodies.size(); ++body) {
                for (std::size_t marker = 0; marker < clip.bodies[body].markers.size(); ++marker, ++sphere) {
                    const Vec3 velocity = (soon.spheres[sphere].centre - scene.spheres[sphere].centre) / soon_s;
                    if (const std::optional<SphereSeen> seen =
                            sphere_seen(camera, without_prism.cameras[at(exposure.camera)], scene.spheres[sphere],
                                        velocity, settings.exposure_s)) {
                        SightedSphere one{static_cast<int>(i), exposure.camera, static_cast<int>(body),
                                          static_cast<int>(marker)};
                        sight(*seen, exposure.spots, settings, one);
                        result.push_back(one);
                    }
                }
            }
        }
    }
    return result;
}

}  // namespace rhexis::tracking
