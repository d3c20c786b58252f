// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/centroid_errors.hpp"

#include <cmath>

#include "base/rng.hpp"
#include "tracking/synthetic/marker_spots.hpp"
#include "tracking/synthetic/renderer.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking {
namespace {

/// On a lattice of 6 x 5 with places drawn within its cells.
synthetic::Scene spread_spheres(double radius_mm, Rng& rng) {
    synthetic::Scene scene;
    for (int i = 0; i < 30; ++i) {
        synthetic::Sphere sphere;
        sphere.centre = Vec3(-125.0 + 50.0 * (i % 6), -100.0 + 50.0 * (i / 6), 440.0);
        sphere.centre += 10.0 * Vec3(rng.uniform(), rng.uniform(), 2.0 * rng.uniform());
        sphere.radius = radius_mm;
        scene.spheres.push_back(sphere);
    }
    return scene;
}

const Spot* nearest_spot(const std::vector<Spot>& spots, const Vec2& at) {
    constexpr double near_px = 3.0;
    const Spot* nearest = nullptr;
    double least = near_px;
    for (const Spot& spot : spots) {
        if (const double off = (spot.at - at).norm(); off < least) {
            least = off;
            nearest = &spot;
        }
    }
    return nearest;
}

}  // namespace

Result<CentroidErrors> measure_centroids(double width_px, int images, std::uint64_t seed,
                                         const SpotSettings& settings) {
    const Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(seed);
    if (!rig) {
        return rig.error();
    }
    CentroidErrors result;
    SpotFinder finder(settings);
    synthetic::RenderScratch scratch;
    synthetic::Image image;
    for (int i = 0; i < images; ++i) {
        synthetic::TrueCamera camera = rig.value().cameras[static_cast<std::size_t>(i) % rig.value().cameras.size()];
        camera.pose = Pose{};
        const synthetic::SensorPattern pattern(camera, seed + static_cast<std::uint64_t>(i));
        Rng rng(seed, "centroids " + std::to_string(i));
        const synthetic::Scene scene = spread_spheres(0.5 * width_px * 450.0 / camera.lens.fx, rng);
        render(camera, pattern, {&scene, 1}, seed * 1000 + static_cast<std::uint64_t>(i), scratch, image);
        const std::vector<Spot>& spots = finder.find(image.view()).spots;
        for (const synthetic::Sphere& sphere : scene.spheres) {
            const Vec2 wanted = distorted(camera.lens, synthetic::outline(sphere).centre);
            const Spot* spot = nearest_spot(spots, wanted);
            if (spot == nullptr) {
                ++result.missed;
                continue;
            }
            ++result.samples;
            result.errors_px.push_back(spot->at.x() - wanted.x());
            result.errors_px.push_back(spot->at.y() - wanted.y());
            result.rms_px += 0.5 * (spot->at - wanted).squaredNorm();
            result.told_sigma_px += spot->sigma_px * spot->sigma_px;
        }
    }
    const auto count = static_cast<double>(std::max<std::int64_t>(result.samples, 1));
    result.rms_px = std::sqrt(result.rms_px / count);
    result.told_sigma_px = std::sqrt(result.told_sigma_px / count);
    return result;
}

}  // namespace rhexis::tracking
