// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/diffuse_light.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/synthetic/window_rays.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr int tile_px = 32;
constexpr double nearest_mm = 20.0;  ///< what is nearer to a camera is not drawn

float& light_at(LightField& field, int x, int y) {
    return field
        .light[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width) + static_cast<std::size_t>(x)];
}

/// Without the part that is not before the camera; false: nothing is left.
bool clip(Capsule& capsule) {
    if (capsule.from.z() > capsule.to.z()) {
        std::swap(capsule.from, capsule.to);
    }
    if (capsule.to.z() <= nearest_mm) {
        return false;
    }
    if (capsule.from.z() < nearest_mm) {
        const double share = (nearest_mm - capsule.from.z()) / (capsule.to.z() - capsule.from.z());
        capsule.from += share * (capsule.to - capsule.from);
    }
    return true;
}

Window window_of(const TrueCamera& camera, const Capsule& capsule) {
    const double widest = capsule.radius + capsule.soft;
    Eigen::AlignedBox2d box;
    for (const Vec3& end : {capsule.from, capsule.to}) {
        const Vec2 direction = end.head<2>() / end.z();
        const Vec2 at = distorted(camera.lens, direction);
        const double near = std::max(end.z() - widest, nearest_mm);
        const double reach = 3.0 + camera.lens.fx * widest / near * (1.0 + direction.squaredNorm());
        box.extend(Vec2(at.array() - reach));
        box.extend(Vec2(at.array() + reach));
    }
    box = box.intersection(Eigen::AlignedBox2d(Vec2(-1.0, -1.0), Vec2(camera.width + 1, camera.height + 1)));
    if (box.isEmpty()) {
        return {};
    }
    return within({static_cast<int>(box.min().x()), static_cast<int>(box.min().y()),
                   static_cast<int>(box.max().x()) + 1, static_cast<int>(box.max().y()) + 1},
                  camera.width, camera.height);
}

double capsule_light(const Capsule& capsule, const Scene& seen, const Vec3& ray) {
    const double far = 2.0 * std::max(capsule.from.norm(), capsule.to.norm());
    const Nearest where = nearest(Vec3::Zero(), far * ray, capsule.from, capsule.to);
    const double cover = 1.0 - smooth_step((where.distance - capsule.radius) / capsule.soft + 0.5);
    if (cover <= 0.0) {
        return 0.0;
    }
    const Vec3 point = where.along_first * far * ray;
    const double side = std::min(1.0, where.distance / capsule.radius);
    double light = capsule.light * cover * std::sqrt(1.0 - 0.8 * side * side) * light_at_mm * light_at_mm /
                   std::max(point.squaredNorm(), nearest_mm * nearest_mm);
    for (const Disc& disc : seen.discs) {
        light *= light_past(disc, Vec3::Zero(), point);
    }
    return light;
}

void add_tile(const TrueCamera& camera, const Capsule& capsule, const Scene& seen, const Window& tile,
              LightField& field) {
    const WindowRays rays(camera.lens, tile);
    const Vec3 middle = rays.at(0.5 * (tile.left + tile.right - 1), 0.5 * (tile.top + tile.bottom - 1));
    const double far = 2.0 * std::max(capsule.from.norm(), capsule.to.norm());
    const double off = nearest(Vec3::Zero(), far * middle, capsule.from, capsule.to).distance;
    const double tile_mm = tile_px * std::max(capsule.from.norm(), capsule.to.norm()) / camera.lens.fx;
    if (off > capsule.radius + capsule.soft + tile_mm) {
        return;
    }
    // no ray is nearer to the rod than to the plane through it and the camera
    const Vec3 across = capsule.from.cross(capsule.to);
    const Vec3 side = across.norm() > 1e-9 ? Vec3(across.normalized()) : Vec3::Zero();
    const double reach = capsule.radius + capsule.soft;
    const double widest = reach / std::max(std::min(capsule.from.z(), capsule.to.z()) - reach, nearest_mm);
    for (int y = tile.top; y < tile.bottom; ++y) {
        const WindowRays::Line line = rays.line(y);
        for (int x = tile.left; x < tile.right; ++x) {
            const Vec3 ray = line.at(x);
            if (std::abs(side.dot(ray)) > widest) {
                continue;
            }
            const double light = capsule_light(capsule, seen, ray) * sensitivity(camera.optics, ray.head<2>());
            float& kept = light_at(field, x, y);
            kept = std::max(kept, static_cast<float>(light));
        }
    }
    field.windows.push_back(tile);
}

void add_point(const Vec2& middle, double light, double sigma, LightField& field) {
    const double reach = 4.0 * sigma + 1.0;
    if (!(middle.x() > -reach && middle.x() < field.width + reach && middle.y() > -reach &&
          middle.y() < field.height + reach)) {
        return;
    }
    const Window window =
        within({static_cast<int>(std::floor(middle.x() - reach)), static_cast<int>(std::floor(middle.y() - reach)),
                static_cast<int>(middle.x() + reach) + 1, static_cast<int>(middle.y() + reach) + 1},
               field.width, field.height);
    if (window.empty()) {
        return;
    }
    for (int y = window.top; y < window.bottom; ++y) {
        for (int x = window.left; x < window.right; ++x) {
            const double away2 = (Vec2(x, y) - middle).squaredNorm();
            light_at(field, x, y) += static_cast<float>(light * std::exp(-0.5 * away2 / (sigma * sigma)));
        }
    }
    field.windows.push_back(window);
}

}  // namespace

double glint_left(const Scene& seen, const Glint& glint) {
    double left = 1.0;
    for (const Sphere& sphere : seen.spheres) {
        const Hit met = hit(sphere, glint.at);
        left = met.share > 0.0 && met.distance < 1.0 ? 0.0 : left;
    }
    for (const Capsule& capsule : seen.capsules) {
        left *= light_past(capsule, Vec3::Zero(), glint.at);
    }
    for (const Disc& disc : seen.discs) {
        left *= light_past(disc, Vec3::Zero(), glint.at);
    }
    return left;
}

Speck draw_speck(int width, int height, Rng& rng) {
    Speck speck;
    speck.at.x() = rng.uniform() * width;
    speck.at.y() = rng.uniform() * height;
    speck.light = 30.0 + 170.0 * rng.uniform();
    speck.sigma_px = 0.4 + 0.6 * rng.uniform();
    return speck;
}

void add_capsules(const TrueCamera& camera, const Scene& seen, LightField& field) {
    for (Capsule capsule : seen.capsules) {
        if (capsule.light <= 0.0 || !clip(capsule)) {
            continue;
        }
        const Window window = window_of(camera, capsule);
        for (int top = window.top; top < window.bottom; top += tile_px) {
            for (int left = window.left; left < window.right; left += tile_px) {
                const Window tile{left, top, std::min(left + tile_px, window.right),
                                  std::min(top + tile_px, window.bottom)};
                add_tile(camera, capsule, seen, tile, field);
            }
        }
    }
}

void add_glints(const TrueCamera& camera, const Scene& seen, LightField& field) {
    for (const Glint& glint : seen.glints) {
        if (glint.at.z() > nearest_mm) {
            const Vec2 middle = distorted(camera.lens, glint.at.head<2>() / glint.at.z());
            add_point(middle, glint.light * glint_left(seen, glint), glint.sigma_px, field);
        }
    }
}

void add_specks(double specks, Rng& rng, LightField& field) {
    // Poisson: how many uniform numbers it takes to multiply down to exp(-mean)
    const double least = std::exp(-specks);
    for (double product = rng.uniform(); product > least; product *= rng.uniform()) {
        const Speck speck = draw_speck(field.width, field.height, rng);
        add_point(speck.at, speck.light, speck.sigma_px, field);
    }
}

}  // namespace rhexis::tracking::synthetic
