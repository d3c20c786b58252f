// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/centroid_errors.hpp"

#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
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
        sphere.centre += 10.0 * uniform3(rng).cwiseProduct(Vec3(1.0, 1.0, 2.0));
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

/// All spheres aside, so that their images go this far.
synthetic::Scene shifted(synthetic::Scene scene, const synthetic::TrueCamera& camera, double by_px) {
    for (synthetic::Sphere& sphere : scene.spheres) {
        sphere.centre.x() += by_px * sphere.centre.z() / camera.lens.fx;
    }
    return scene;
}

/// Standard deviation of a sphere's place that the noise of its pixels leaves to the best finder, by how their light
/// changes with the place.
void add_bounds(const synthetic::TrueCamera& camera, const synthetic::Scene& scene, synthetic::RenderScratch& scratch,
                std::vector<double>& bounds_px) {
    constexpr double step_px = 0.1;
    constexpr double rounding = 1.0 / 12.0;
    render_light(camera, {&scene, 1}, 0, scratch);
    const std::vector<float> light = scratch.field.light;
    const synthetic::Scene beside = shifted(scene, camera, step_px);
    render_light(camera, {&beside, 1}, 0, scratch);
    for (const synthetic::Sphere& sphere : scene.spheres) {
        const synthetic::Window window = within(window_of(camera, sphere, 2.0), camera.width, camera.height);
        double information = 0.0;
        for (int y = window.top; y < window.bottom; ++y) {
            for (int x = window.left; x < window.right; ++x) {
                const std::size_t pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x);
                const double slope = (static_cast<double>(scratch.field.light[pixel]) - light[pixel]) / step_px;
                const double all_light = static_cast<double>(light[pixel]) + scene.ambient;
                information += slope * slope /
                               (camera.sensor.read_noise * camera.sensor.read_noise + rounding +
                                all_light / camera.sensor.electrons);
            }
        }
        if (information > 0.0) {
            bounds_px.push_back(1.0 / std::sqrt(information));
        }
    }
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
        if (i == 0) {
            add_bounds(camera, scene, scratch, result.bounds_px);
        }
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
