// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/marker_patch.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// The same camera, of which only this window is looked at, in whose frame all things are.
TrueCamera cropped(const TrueCamera& camera, const Window& window) {
    TrueCamera crop = camera;
    crop.width = window.width();
    crop.height = window.height();
    crop.lens.cx -= window.left;
    crop.lens.cy -= window.top;
    crop.pose = Pose{};
    // the blur of this place of the whole image
    const Vec2 half{0.5 * camera.width, 0.5 * camera.height};
    const Vec2 middle{0.5 * (window.left + window.right), 0.5 * (window.top + window.bottom)};
    crop.optics.psf_px += crop.optics.psf_rim_px * (middle - half).squaredNorm() / half.squaredNorm();
    crop.optics.psf_rim_px = 0.0;
    return crop;
}

/// Spheres that are not looked at may hide one that is.
void keep_only(const Scene& instant, const std::vector<int>& spheres, const std::vector<int>& glints, Hiders& hiders,
               Scene& kept) {
    kept = instant;
    std::vector<int> needed = spheres;
    for (const int sphere : spheres) {
        find_hiders(instant, sphere, hiders);
        needed.insert(needed.end(), hiders.spheres.begin(), hiders.spheres.end());
    }
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    kept.spheres.clear();
    for (const int sphere : needed) {
        kept.spheres.push_back(instant.spheres[at(sphere)]);
    }
    kept.glints.clear();
    for (const int glint : glints) {
        kept.glints.push_back(instant.glints[at(glint)]);
    }
    kept.specks = 0.0;
}

/// Whether any of these goes farther within the exposure than shows; else its middle stands for all of it.
bool moves(const TrueCamera& camera, std::span<const Scene> instants, const std::vector<int>& spheres) {
    constexpr double shows_px = 0.1;
    return std::any_of(spheres.begin(), spheres.end(), [&](int sphere) {
        const Vec3& first = instants.front().spheres[at(sphere)].centre;
        const Vec3& last = instants.back().spheres[at(sphere)].centre;
        return (last - first).norm() * camera.lens.fx > shows_px * first.z();
    });
}

void expose_patch(const Sensor& sensor, const LightField& field, double ambient, Rng& rng, Image& image) {
    image.width = field.width;
    image.height = field.height;
    image.pixels.resize(field.light.size());
    for (std::size_t i = 0; i < field.light.size(); ++i) {
        const double light = ambient + static_cast<double>(field.light[i]);
        const double spread = std::sqrt(sensor.read_noise * sensor.read_noise + light / sensor.electrons);
        const double value = sensor.black + light + spread * rng.normal() + 0.5;
        image.pixels[i] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
    }
}

}  // namespace

std::vector<Spot> spots_of_patch(const TrueCamera& camera, std::span<const Scene> instants,
                                 const std::vector<int>& spheres, const std::vector<int>& glints, const Window& window,
                                 const SpotSettings& finder, Rng& rng, PatchScratch& scratch) {
    const TrueCamera crop = cropped(camera, window);
    const std::span<const Scene> needed =
        moves(camera, instants, spheres) ? instants : instants.subspan(instants.size() / 2, 1);
    scratch.instants.resize(needed.size());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        keep_only(needed[i], spheres, glints, scratch.render.hiders, scratch.instants[i]);
    }
    render_light(crop, scratch.instants, 0, scratch.render, {2, 1, 1});
    expose_patch(camera.sensor, scratch.render.field, instants[instants.size() / 2].ambient, rng, scratch.image);
    std::vector<Spot> spots = SpotFinder(finder).find(scratch.image.view()).spots;
    for (Spot& spot : spots) {
        spot.at += Vec2(window.left, window.top);
    }
    return spots;
}

}  // namespace rhexis::tracking::synthetic
