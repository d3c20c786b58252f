// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/outline_spots.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "tracking/synthetic/diffuse_light.hpp"
#include "tracking/synthetic/spot_parts.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// Standard deviation of a whole outline's centre that the sensor's noise at the rim makes [pixels].
double outline_sigma(const TrueCamera& camera, const Sphere& seen, const OutlineNoise& noise) {
    constexpr double rim_width = 2.5;  // of a step that is blurred, in standard deviations of the blur
    const double rim_light = light_of_middle(camera, seen) * (1.0 - seen.lobe);
    const Sensor& sensor = camera.sensor;
    const double light_noise = std::sqrt(sensor.read_noise * sensor.read_noise + 0.5 * rim_light / sensor.electrons);
    const double slope = rim_light / (rim_width * camera.optics.psf_px);
    return noise.shot * light_noise / slope * std::sqrt(2.0 / outline_rays);
}

/// The same for a place of a camera's image whenever it is asked for: two normal deviates.
Vec2 deviates_at(const TrueCamera& camera, const Vec2& place, double cell_px) {
    const auto column = static_cast<std::int64_t>(std::floor(place.x() / cell_px));
    const auto line = static_cast<std::int64_t>(std::floor(place.y() / cell_px));
    Rng rng((static_cast<std::uint64_t>(column) << 32U) + static_cast<std::uint64_t>(line), camera.name);
    const double x = rng.normal();
    return {x, rng.normal()};
}

/// What the finder is off where nothing is wrong, the same as long as the spot rests.
Vec2 outline_bias(const TrueCamera& camera, const Vec2& place, double radius, const OutlineNoise& noise) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const double most = noise.within_px * std::cos(turn * (radius - noise.within_from_px));
    const Vec2 middle{0.5 * (camera.width - 1), 0.5 * (camera.height - 1)};
    return most * Vec2(std::sin(turn * place.x()), std::sin(turn * place.y())) - noise.inward * (place - middle) +
           noise.pattern_px * deviates_at(camera, place, noise.pattern_of_px);
}

/// A sphere that is whole, clean and alone.
void add_outline(const TrueCamera& camera, int sphere, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    constexpr double told_of_a_ray_px = 0.06;  // by the finder, at the least
    SpotScratch::Part part = part_of(camera, sphere, Left{}, scratch);
    const Vec2 normal{rng.normal(), rng.normal()};
    const double radius = radius_of(part.spot);
    const double narrower = 1.0 - options.outline.inside_px / radius;
    part.settled = true;
    part.spot.sigma_px = told_of_a_ray_px * std::sqrt(2.0 / outline_rays);
    if (radius * narrower < options.finder.small_radius) {
        const double sigma = centroid_sigma(camera.sensor, options.noise, part.light / part.spot.area, radius);
        part.spot.at = mean_centre(camera, scratch.seen, sphere) + sigma * normal;
    } else {
        const Vec2 place = mean_outline(camera, scratch.seen, sphere);
        const Sphere& seen = scratch.seen[scratch.seen.size() / 2].spheres[at(sphere)];
        part.spot.at = place + outline_bias(camera, place, part.radius, options.outline) +
                       outline_sigma(camera, seen, options.outline) * normal;
    }
    part.spot.area *= narrower * narrower;
    const double stretch =
        options.outline.stretch * (1.0 - part.spot.roundness) / (1.0 + part.spot.roundness);  // by the radius
    part.spot.roundness = (1.0 - stretch) / (1.0 + stretch);
    scratch.parts.push_back(part);
}

/// Spheres and glints as they shine in the image, with those that hide behind something left out.
void find_bright(const TrueCamera& camera, const SpotOptions& options, SpotScratch& scratch) {
    constexpr double smears_px = 0.3;  // the finder's ellipse is not made for what is longer
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    scratch.bright.clear();
    for (int i = 0; i < static_cast<int>(seen.spheres.size()); ++i) {
        Left left;
        if (!may_be_seen(camera, scratch.seen, i) || !is_left(camera, i, options, scratch, left)) {
            continue;
        }
        SpotScratch::Bright bright;
        bright.sphere = i;
        bright.at = mean_outline(camera, scratch.seen, i);
        const double moved = smear(camera, scratch.seen, i).norm();
        bright.odd = !scratch.hiders.none() || shows_wear(seen.spheres[at(i)]) || moved > smears_px;
        bright.radius = part_of(camera, i, Left{}, scratch).radius + 0.5 * moved;
        scratch.bright.push_back(bright);
    }
    const double least_light = least_light_of(camera, options, seen.ambient);
    for (int i = 0; i < static_cast<int>(seen.glints.size()); ++i) {
        const Glint& glint = seen.glints[at(i)];
        const std::optional<Vec2> image = glint_image(camera, glint);
        const double light = image ? glint.light * glint_left(seen, glint) : 0.0;
        if (light > 0.1 * least_light) {
            // also of one that is too dim to be a spot: it shines into others
            const double reach = glint.sigma_px * std::sqrt(2.0 * std::log(std::max(light / least_light, 1.5)));
            SpotScratch::Bright bright;
            bright.glint = i;
            bright.at = *image;
            bright.radius = reach;
            scratch.bright.push_back(bright);
        }
    }
}

/// Those whose light the finder would not tell apart get the same group, also by way of others.
void group_bright(std::vector<SpotScratch::Bright>& bright) {
    constexpr double apart_px = 6.0;  // within twice the finder's margin spots are crowded
    for (std::size_t i = 0; i < bright.size(); ++i) {
        bright[i].group = i;
        for (std::size_t j = 0; j < i; ++j) {
            if ((bright[i].at - bright[j].at).norm() < bright[i].radius + bright[j].radius + apart_px) {
                const std::size_t from = bright[j].group;
                for (std::size_t k = 0; k <= i; ++k) {
                    bright[k].group = bright[k].group == from ? bright[i].group : bright[k].group;
                }
            }
        }
    }
}

/// The part of the image that a group's light reaches, with what lies around it.
Window window_of_group(const TrueCamera& camera, const std::vector<SpotScratch::Bright>& bright, std::size_t group) {
    constexpr double around_px = 10.0;
    Eigen::AlignedBox2d box;
    for (const SpotScratch::Bright& one : bright) {
        if (one.group == group) {
            box.extend(Vec2(one.at.array() - one.radius - around_px));
            box.extend(Vec2(one.at.array() + one.radius + around_px));
        }
    }
    const Vec2 low = box.min().array().floor();
    const Vec2 high = box.max().array().ceil();
    return within({static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()) + 1,
                   static_cast<int>(high.y()) + 1},
                  camera.width, camera.height);
}

/// The sphere that a spot lies on; -1: none of the group.
int sphere_at(const std::vector<SpotScratch::Bright>& bright, std::size_t group, const Vec2& place) {
    int nearest = -1;
    double least = 0.0;
    for (const SpotScratch::Bright& one : bright) {
        const double off = (one.at - place).norm();
        if (one.group == group && one.sphere >= 0 && off < one.radius && (nearest < 0 || off < least)) {
            nearest = one.sphere;
            least = off;
        }
    }
    return nearest;
}

void add_patch(const TrueCamera& camera, std::size_t group, const SpotOptions& options, Rng& rng,
               SpotScratch& scratch) {
    std::vector<int> spheres;
    std::vector<int> glints;
    for (const SpotScratch::Bright& one : scratch.bright) {
        if (one.group == group) {
            (one.sphere >= 0 ? spheres : glints).push_back(one.sphere >= 0 ? one.sphere : one.glint);
        }
    }
    const Window window = window_of_group(camera, scratch.bright, group);
    if (window.empty()) {
        return;
    }
    for (const Spot& spot :
         spots_of_patch(camera, scratch.seen, spheres, glints, window, options.finder, rng, scratch.patch)) {
        SpotScratch::Part part;
        part.spot = spot;
        part.radius = radius_of(spot);
        part.light = spot.area * spot.peak;
        part.sphere = sphere_at(scratch.bright, group, spot.at);
        part.settled = true;
        scratch.parts.push_back(part);
    }
}

}  // namespace

void add_outlines(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    find_bright(camera, options, scratch);
    group_bright(scratch.bright);
    for (std::size_t i = 0; i < scratch.bright.size(); ++i) {
        const SpotScratch::Bright one = scratch.bright[i];
        const auto same = [&one](const SpotScratch::Bright& other) { return other.group == one.group; };
        const auto first = std::find_if(scratch.bright.begin(), scratch.bright.end(), same);
        const auto count = std::count_if(first, scratch.bright.end(), same);
        if (count > 1 || one.odd) {
            if (first - scratch.bright.begin() == static_cast<std::ptrdiff_t>(i)) {
                add_patch(camera, one.group, options, rng, scratch);
            }
        } else if (one.sphere >= 0) {
            add_outline(camera, one.sphere, options, rng, scratch);
        } else {
            add_glint(camera, scratch.seen[scratch.seen.size() / 2].glints[at(one.glint)], options, rng, scratch);
        }
    }
}

}  // namespace rhexis::tracking::synthetic
