// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/marker_spots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "tracking/synthetic/outline_spots.hpp"
#include "tracking/synthetic/spot_parts.hpp"

namespace rhexis::tracking::synthetic {
namespace {

Vec2 radial(const Vec3& centre) {
    const double length = centre.head<2>().norm();
    return length > 0.0 ? Vec2(centre.head<2>() / length) : Vec2::UnitX();
}

void add_sphere(const TrueCamera& camera, int sphere, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    Left left;
    if (!may_be_seen(camera, scratch.seen, sphere) || !is_left(camera, sphere, options, scratch, left)) {
        return;
    }
    SpotScratch::Part part = part_of(camera, sphere, left, scratch);
    const double sigma =
        centroid_sigma(camera.sensor, options.noise, part.light / part.spot.area, radius_of(part.spot));
    const Vec2 normal{rng.normal(), rng.normal()};
    part.spot.at = mean_centre(camera, scratch.seen, sphere) + left.shift + sigma * normal;
    scratch.parts.push_back(part);
}

void add_lights(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    for (int i = 0; i < static_cast<int>(seen.spheres.size()); ++i) {
        add_sphere(camera, i, options, rng, scratch);
    }
    for (const Glint& glint : seen.glints) {
        add_glint(camera, glint, options, rng, scratch);
    }
}

/// The second becomes part of the first.
void merge(SpotScratch::Part& first, const SpotScratch::Part& second) {
    const double light = first.light + second.light;
    const double share = second.light / light;
    const Vec2 apart = second.spot.at - first.spot.at;
    const double area = first.spot.area + second.spot.area;
    const double least = 0.25 * std::min(first.spot.area, second.spot.area) / std::numbers::pi;
    const double greatest = 0.25 * std::max(first.spot.area, second.spot.area) / std::numbers::pi +
                            share * (1.0 - share) * apart.squaredNorm();
    first.sphere = share > 0.5 ? second.sphere : first.sphere;
    first.spot.at += share * apart;
    first.spot.sigma_px = 0.0;
    first.spot.roundness = std::min({first.spot.roundness, second.spot.roundness, std::sqrt(least / greatest)});
    first.spot.area = area;
    first.spot.peak = std::max(first.spot.peak, second.spot.peak);
    first.spot.clipped = first.spot.clipped || second.spot.clipped;
    first.radius = std::max(first.radius, 0.5 * (apart.norm() + first.radius + second.radius));
    first.light = light;
}

/// Those that touch get the same group, also by way of others.
void find_groups(double gap, std::vector<SpotScratch::Part>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].group = i;
        for (std::size_t j = 0; j < i; ++j) {
            const double reach = parts[i].radius + parts[j].radius + gap;
            if ((parts[i].settled && parts[j].settled) ||
                (parts[i].spot.at - parts[j].spot.at).squaredNorm() >= reach * reach) {
                continue;
            }
            const std::size_t from = parts[j].group;
            for (std::size_t k = 0; k <= i; ++k) {
                parts[k].group = parts[k].group == from ? parts[i].group : parts[k].group;
            }
        }
    }
}

void merge_touching(double gap, std::vector<SpotScratch::Part>& parts) {
    find_groups(gap, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = parts.size() - 1; j > i; --j) {
            if (parts[j].group == parts[i].group) {
                merge(parts[i], parts[j]);
                parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
            }
        }
    }
}

}  // namespace

Outline outline(const Sphere& seen) {
    const double sine = seen.radius / seen.centre.norm();
    const double off_axis = std::atan2(seen.centre.head<2>().norm(), seen.centre.z());
    const double half = std::asin(sine);
    const double outer = std::tan(off_axis + half);
    const double inner = std::tan(off_axis - half);
    const double cosine = std::cos(off_axis);
    return {0.5 * (outer + inner) * radial(seen.centre), 0.5 * (outer - inner),
            sine / std::sqrt(cosine * cosine - sine * sine)};
}

Vec2 centre_of_light(const TrueCamera& camera, const Sphere& seen) {
    const Outline ellipse = outline(seen);
    const double spread = lobe_spread(seen.lobe);
    const Vec2 direction = seen.centre.head<2>() / seen.centre.z();
    const Vec2 middle = direction + spread * (ellipse.centre - direction);
    const Vec2 along = radial(seen.centre);
    const Vec2 across{-along.y(), along.x()};
    // four points with the mean squares of the light: vignetting and the lens's bends to second order
    Vec2 sum = Vec2::Zero();
    double weights = 0.0;
    for (const double side : {-1.0, 1.0}) {
        for (const Vec2& step : {Vec2(ellipse.along * along), Vec2(ellipse.across * across)}) {
            const Vec2 place = middle + side * std::sqrt(0.5 * spread) * step;
            const double weight =
                sensitivity(camera.optics, place) * distortion_slope(camera.lens, place).determinant();
            sum += weight * distorted(camera.lens, place);
            weights += weight;
        }
    }
    return sum / weights;
}

void spots_without_images(const TrueCamera& camera, std::span<const Scene> instants, const SpotOptions& options,
                          Rng& rng, SpotScratch& scratch, std::vector<Spot>& spots) {
    RHEXIS_ASSERT(!instants.empty());
    scratch.seen.resize(instants.size());
    for (std::size_t i = 0; i < instants.size(); ++i) {
        seen_from(camera.pose, instants[i], scratch.seen[i]);
    }
    scratch.parts.clear();
    if (options.centre == SpotCentre::outline) {
        add_outlines(camera, options, rng, scratch);
    } else {
        add_lights(camera, options, rng, scratch);
    }
    add_specks(camera, options, rng, scratch);
    merge_touching(options.gap_px, scratch.parts);
    std::sort(scratch.parts.begin(), scratch.parts.end(), [](const SpotScratch::Part& a, const SpotScratch::Part& b) {
        return a.spot.at.y() - a.radius < b.spot.at.y() - b.radius;
    });
    spots.clear();
    scratch.sphere_of.clear();
    for (SpotScratch::Part& part : scratch.parts) {
        const Vec2& middle = part.spot.at;
        part.spot.at_rim = part.spot.at_rim || middle.x() < part.radius || middle.y() < part.radius ||
                           middle.x() > camera.width - 1 - part.radius || middle.y() > camera.height - 1 - part.radius;
        spots.push_back(part.spot);
        scratch.sphere_of.push_back(part.sphere);
    }
}

}  // namespace rhexis::tracking::synthetic
