// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "base/rng.hpp"
#include "tracking/synthetic/blur.hpp"
#include "tracking/synthetic/board_light.hpp"
#include "tracking/synthetic/diffuse_light.hpp"
#include "tracking/synthetic/window_rays.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// Of one sphere at one instant, added to the window's light and share.
class SphereSampler {
public:
    SphereSampler(const Scene& seen, int sphere, const Hiders& hiders, const WindowRays& rays, double pixel,
                  const Fineness& fineness)
        : seen_(seen),
          sphere_(sphere),
          hiders_(hiders),
          rays_(rays),
          pixel_(pixel),
          fineness_(fineness),
          even_(hiders.none() && seen.spheres[at(sphere)].worn_cosine > 1.0) {
        const Sphere& it = seen.spheres[at(sphere)];
        const double distance = it.centre.norm();
        towards_ = it.centre / distance;
        sine_ = it.radius / distance;
    }

    /// Of a pixel whose middle has this ray.
    [[nodiscard]] Shine pixel(int x, int y, const Vec3& ray) const {
        const double off = ray.normalized().cross(towards_).norm();
        if (off > sine_ + pixel_) {
            return {};
        }
        const bool inside = off < sine_ - 1.5 * pixel_;
        return mean(x, y, !inside ? fineness_.rays : even_ ? fineness_.inside : fineness_.inside_odd);
    }

private:
    [[nodiscard]] Shine mean(int x, int y, int count) const {
        Shine sum;
        for (int i = 0; i < count; ++i) {
            const WindowRays::Line line = rays_.line(y + (i + 0.5) / count - 0.5);
            for (int j = 0; j < count; ++j) {
                const Vec3 ray = line.at(x + (j + 0.5) / count - 0.5);
                const Shine one = shine(seen_, sphere_, hiders_, ray, pixel_ / count);
                sum.light += one.light;
                sum.share += one.share;
            }
        }
        const double each = 1.0 / (count * count);
        return {sum.light * each, sum.share * each};
    }

    const Scene& seen_;
    int sphere_;
    const Hiders& hiders_;
    const WindowRays& rays_;
    Vec3 towards_;
    double sine_;
    double pixel_;  ///< angle that a pixel takes on the axis [rad]
    Fineness fineness_;
    bool even_;  ///< neither hidden nor worn
};

/// All of the instants' windows; empty: out of the image, or behind the camera.
Window window_of_all(const TrueCamera& camera, std::span<const Scene> seen, int sphere) {
    Window all;
    for (const Scene& instant : seen) {
        const Window one = window_of(camera, instant.spheres[at(sphere)], 1.0);
        if (one.empty()) {
            return {};
        }
        all = all.empty() ? one
                          : Window{std::min(all.left, one.left), std::min(all.top, one.top),
                                   std::max(all.right, one.right), std::max(all.bottom, one.bottom)};
    }
    const Window seen_part = within(all, camera.width, camera.height);
    return seen_part.empty() ? Window{} : all;
}

void sample_sphere(const TrueCamera& camera, const Scene& seen, int sphere, const Window& window,
                   const Window& instant_window, const Fineness& fineness, RenderScratch& scratch) {
    const WindowRays rays(camera.lens, instant_window);
    const SphereSampler sampler(seen, sphere, scratch.hiders, rays, 1.0 / std::min(camera.lens.fx, camera.lens.fy),
                                fineness);
    for (int y = instant_window.top; y < instant_window.bottom; ++y) {
        const WindowRays::Line line = rays.line(y);
        for (int x = instant_window.left; x < instant_window.right; ++x) {
            const Vec3 ray = line.at(x);
            const Shine shine = sampler.pixel(x, y, ray);
            const std::size_t place =
                static_cast<std::size_t>(y - window.top) * static_cast<std::size_t>(window.width()) +
                static_cast<std::size_t>(x - window.left);
            scratch.light[place] += static_cast<float>(shine.light * sensitivity(camera.optics, ray.head<2>()));
            scratch.share[place] += static_cast<float>(shine.share);
        }
    }
}

/// A window's light over what is in the field already, which the sphere hides.
void lay_over(const Window& window, double each, const RenderScratch& scratch, LightField& field) {
    const Window part = within(window, field.width, field.height);
    for (int y = part.top; y < part.bottom; ++y) {
        for (int x = part.left; x < part.right; ++x) {
            const std::size_t place =
                static_cast<std::size_t>(y - window.top) * static_cast<std::size_t>(window.width()) +
                static_cast<std::size_t>(x - window.left);
            float& light = field.light[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width) +
                                       static_cast<std::size_t>(x)];
            const float scale = static_cast<float>(each);
            light = light * std::max(0.0F, 1.0F - scale * scratch.share[place]) + scale * scratch.light[place];
        }
    }
    field.windows.push_back(part);
}

void add_sphere(const TrueCamera& camera, int sphere, const Fineness& fineness, RenderScratch& scratch) {
    const Window window = window_of_all(camera, scratch.seen, sphere);
    if (window.empty()) {
        return;
    }
    const auto count = static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(window.height());
    scratch.light.assign(count, 0.0F);
    scratch.share.assign(count, 0.0F);
    for (const Scene& seen : scratch.seen) {
        find_hiders(seen, sphere, scratch.hiders);
        sample_sphere(camera, seen, sphere, window, window_of(camera, seen.spheres[at(sphere)], 1.0), fineness,
                      scratch);
    }
    const Vec3& middle = scratch.seen[scratch.seen.size() / 2].spheres[at(sphere)].centre;
    const Vec2 pixel = distorted(camera.lens, middle.head<2>() / middle.z());
    const double sigma = psf_sigma(camera, pixel, middle.z());
    blur(scratch.light, window.width(), window.height(), sigma, scratch.line);
    blur(scratch.share, window.width(), window.height(), sigma, scratch.line);
    lay_over(window, 1.0 / static_cast<double>(scratch.seen.size()), scratch, scratch.field);
}

}  // namespace

Window window_of(const TrueCamera& camera, const Sphere& seen, double more) {
    constexpr double widest_blur = 0.9 * blur_reach;
    if (seen.centre.z() <= 2.0 * seen.radius) {
        return {};
    }
    const Vec2 direction = seen.centre.head<2>() / seen.centre.z();
    if (direction.squaredNorm() > 1.0) {
        return {};  // far outside, where the lens's polynomials mean nothing
    }
    const Vec2 middle = distorted(camera.lens, direction);
    const double focal = std::max(camera.lens.fx, camera.lens.fy);
    const double reach = widest_blur + more + 1.0 +
                         focal * seen.radius / (seen.centre.z() - seen.radius) * (1.0 + direction.squaredNorm());
    return {static_cast<int>(std::floor(middle.x() - reach)), static_cast<int>(std::floor(middle.y() - reach)),
            static_cast<int>(std::ceil(middle.x() + reach)) + 1, static_cast<int>(std::ceil(middle.y() + reach)) + 1};
}

void render_light(const TrueCamera& camera, std::span<const Scene> instants, std::uint64_t image_seed,
                  RenderScratch& scratch, const Fineness& fineness) {
    RHEXIS_ASSERT(!instants.empty());
    scratch.field.clear(camera.width, camera.height);
    scratch.seen.resize(instants.size());
    for (std::size_t i = 0; i < instants.size(); ++i) {
        RHEXIS_ASSERT(instants[i].spheres.size() == instants[0].spheres.size());
        seen_from(camera.pose, instants[i], scratch.seen[i]);
    }
    const Scene& middle = scratch.seen[instants.size() / 2];
    add_boards(camera, middle, scratch.board, scratch.field);
    add_capsules(camera, middle, scratch.field);
    for (int i = 0; i < static_cast<int>(middle.spheres.size()); ++i) {
        add_sphere(camera, i, fineness, scratch);
    }
    add_glints(camera, middle, scratch.field);
    Rng rng(image_seed, "specks");
    add_specks(middle.specks, rng, scratch.field);
}

void render(const TrueCamera& camera, const SensorPattern& pattern, std::span<const Scene> instants,
            std::uint64_t image_seed, RenderScratch& scratch, Image& image) {
    RHEXIS_ASSERT(pattern.dark().size() ==
                  static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
    render_light(camera, instants, image_seed, scratch);
    expose(camera.sensor, pattern, scratch.field, instants[instants.size() / 2].ambient, image_seed, image);
}

}  // namespace rhexis::tracking::synthetic
