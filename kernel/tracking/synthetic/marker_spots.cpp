// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/marker_spots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "tracking/synthetic/diffuse_light.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr double far_outside = 1.0;  ///< |(X/Z, Y/Z)| where the lens's polynomials mean nothing any more

/// Mean square of the distance from the middle, by that of an evenly lit disc: the lobe takes light from the limb.
double lobe_spread(double lobe) { return (0.5 - lobe / 3.0) / (0.5 - lobe / 4.0); }
double lobe_mean(double lobe) { return 1.0 - 0.5 * lobe; }

Vec2 radial(const Vec3& centre) {
    const double length = centre.head<2>().norm();
    return length > 0.0 ? Vec2(centre.head<2>() / length) : Vec2::UnitX();
}

/// What part of a sphere's light is left, and how far the centre of light and its spread are moved by what is missing.
struct Left {
    double share = 1.0;
    double light = 1.0;
    Vec2 shift = Vec2::Zero();
    double least = 1.0;  ///< standard deviation of the light across and along, by those of the whole sphere
    double greatest = 1.0;
};

struct Moments {
    double light = 0.0;
    Vec2 first = Vec2::Zero();
    Mat2 second = Mat2::Zero();

    void add(const Vec2& place, double weight) {
        light += weight;
        first += weight * place;
        second += weight * place * place.transpose();
    }
    [[nodiscard]] Vec2 mean() const { return first / light; }
    /// Standard deviations, the lesser first.
    [[nodiscard]] Vec2 spreads() const {
        const Mat2 central = second / light - mean() * mean().transpose();
        const double half = 0.5 * central.trace();
        const double root = std::sqrt(std::max(0.0, half * half - central.determinant()));
        return {std::sqrt(std::max(0.0, half - root)), std::sqrt(half + root)};
    }
};

/// Whether any of its worn patch is on the side that the camera sees.
bool shows_wear(const Sphere& seen) {
    constexpr double edge = 0.05;  // the patch's edge is soft
    const double sine = std::sqrt(std::max(0.0, 1.0 - seen.worn_cosine * seen.worn_cosine)) + edge;
    return seen.worn_cosine <= 1.0 && -seen.worn_towards.dot(seen.centre.normalized()) > -sine;
}

/// Samples on a spiral of golden angles.
void fill_disc(std::vector<Vec2>& disc) {
    constexpr int count = 200;
    constexpr double golden_turn = 2.39996322972865332;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt((i + 0.5) / count);
        disc.emplace_back(radius * std::cos(i * golden_turn), radius * std::sin(i * golden_turn));
    }
}

Left what_is_left(const TrueCamera& camera, const Scene& seen, int sphere, SpotScratch& scratch) {
    if (scratch.disc.empty()) {
        fill_disc(scratch.disc);
    }
    const Sphere& it = seen.spheres[at(sphere)];
    const double distance = it.centre.norm();
    const double light = it.light * light_at_mm * light_at_mm / (distance * distance);
    const double sine = it.radius / distance;
    const Vec3 towards = it.centre / distance;
    const Vec3 across = towards.unitOrthogonal();
    const Vec3 down = towards.cross(across);
    const Vec2 direction = it.centre.head<2>() / it.centre.z();
    const Mat2 slope = distortion_slope(camera.lens, direction);
    Moments all;
    Moments left;
    double share = 0.0;
    for (const Vec2& place : scratch.disc) {
        const double cosine2 = 1.0 - place.squaredNorm();
        const Vec3 ray =
            std::sqrt(1.0 - sine * sine * (1.0 - cosine2)) * towards + sine * (place.x() * across + place.y() * down);
        const Vec2 pixel = slope * (ray.head<2>() / ray.z() - direction);
        const Shine now = shine(seen, sphere, scratch.hiders, ray);
        all.add(pixel, 1.0 - it.lobe * (1.0 - cosine2));
        left.add(pixel, now.light / light);
        share += now.share / static_cast<double>(scratch.disc.size());
    }
    Left result;
    result.share = share;
    result.light = left.light / all.light;
    if (result.light > 0.0) {
        const Vec2 before = all.spreads();
        const Vec2 after = left.spreads();
        result.shift = left.mean() - all.mean();
        result.least = after.x() / before.x();
        result.greatest = after.y() / before.y();
    }
    return result;
}

/// How far a sphere's image moves within the exposure, from its first instant's middle to its last one's, and half an
/// instant at both ends.
Vec2 smear(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere) {
    if (seen.size() < 2) {
        return Vec2::Zero();
    }
    const Vec3& first = seen.front().spheres[at(sphere)].centre;
    const Vec3& last = seen.back().spheres[at(sphere)].centre;
    const Vec2 moved =
        distorted(camera.lens, last.head<2>() / last.z()) - distorted(camera.lens, first.head<2>() / first.z());
    const auto count = static_cast<double>(seen.size());
    return moved * count / (count - 1.0);
}

Vec2 mean_centre(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere) {
    Vec2 sum = Vec2::Zero();
    for (const Scene& instant : seen) {
        sum += centre_of_light(camera, instant.spheres[at(sphere)]);
    }
    return sum / static_cast<double>(seen.size());
}

Vec2 mean_outline(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere) {
    Vec2 sum = Vec2::Zero();
    for (const Scene& instant : seen) {
        sum += distorted(camera.lens, outline(instant.spheres[at(sphere)]).centre);
    }
    return sum / static_cast<double>(seen.size());
}

bool may_be_seen(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere) {
    for (const Scene& instant : seen) {
        const Vec3& centre = instant.spheres[at(sphere)].centre;
        if (centre.z() <= 2.0 * instant.spheres[at(sphere)].radius ||
            (centre.head<2>() / centre.z()).norm() > far_outside) {
            return false;
        }
    }
    const Vec3& centre = seen[seen.size() / 2].spheres[at(sphere)].centre;
    const Vec2 pixel = distorted(camera.lens, centre.head<2>() / centre.z());
    return pixel.x() > 0.0 && pixel.y() > 0.0 && pixel.x() < camera.width - 1 && pixel.y() < camera.height - 1;
}

/// Standard deviation of a light-weighted centroid [pixels]; `radius` is that of a disc that spreads as the spot does.
double centroid_sigma(const Sensor& sensor, const CentroidNoise& noise, double light, double radius) {
    constexpr double rounding = 1.0 / 12.0;
    const double variance = sensor.read_noise * sensor.read_noise + light / sensor.electrons + rounding;
    const double wider = 1.0 + noise.rim_px / radius;
    const double shot = 0.5 * std::sqrt(variance * std::numbers::inv_pi) / light * wider * wider;
    return std::hypot(noise.floor_px, noise.shot * shot);
}

void set_brightness(const TrueCamera& camera, double ambient, double light, Spot& spot) {
    const Sensor& sensor = camera.sensor;
    const double noise = std::sqrt(sensor.read_noise * sensor.read_noise + light / sensor.electrons);
    const double brightest = sensor.black + ambient + light + 2.0 * noise;
    spot.peak = std::min(255.0, std::floor(brightest + 0.5));
    spot.clipped = brightest >= 255.0;
}

void add_sphere(const TrueCamera& camera, int sphere, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    const Sphere& it = seen.spheres[at(sphere)];
    if (!may_be_seen(camera, scratch.seen, sphere)) {
        return;
    }
    find_hiders(seen, sphere, scratch.hiders);
    Left left;
    if (!scratch.hiders.none() || shows_wear(it)) {
        left = what_is_left(camera, seen, sphere, scratch);
    }
    const Vec2 direction = it.centre.head<2>() / it.centre.z();
    const double distance2 = it.centre.squaredNorm() / (light_at_mm * light_at_mm);
    const double middle_light = it.light / distance2 * sensitivity(camera.optics, direction);
    if (left.share < options.least_share || middle_light * left.light / left.share < options.least_light) {
        return;
    }
    std::optional<MarkerOutline> fitted;
    if (options.centre == SpotCentre::outline) {
        fitted = marker_outline(camera, seen, sphere, scratch.hiders, middle_light, options.outline);
    }
    if (fitted) {
        left.share = left.least = left.greatest = 1.0;
        left.light = std::max(left.light, fitted->share);
    }
    const Outline ellipse = outline(it);
    const Mat2 slope = distortion_slope(camera.lens, direction);
    const double focal = std::sqrt(slope.determinant());
    const double moved = smear(camera, scratch.seen, sphere).norm();
    const double spread_share = 0.5 * std::sqrt(lobe_spread(it.lobe));
    const double least = focal * ellipse.across * spread_share * left.least;
    const double greatest = std::hypot(focal * ellipse.along * spread_share * left.greatest, moved / std::sqrt(12.0));
    SpotScratch::Part part;
    part.sphere = sphere;
    part.radius = focal * ellipse.along;
    part.spot.area = std::numbers::pi * focal * focal * ellipse.along * ellipse.across * left.share +
                     2.0 * focal * ellipse.across * moved;
    part.spot.roundness = std::min(1.0, least / greatest);
    const double mean_light = middle_light * lobe_mean(it.lobe) * left.light / left.share *
                              (part.spot.area / (part.spot.area + focal * ellipse.across * moved));
    part.light = mean_light * part.spot.area;
    set_brightness(camera, seen.ambient, middle_light * left.light / left.share, part.spot);
    const double sigma =
        centroid_sigma(camera.sensor, options.noise, mean_light, std::sqrt(part.spot.area * std::numbers::inv_pi));
    const Vec2 normal{rng.normal(), rng.normal()};
    if (fitted) {
        part.spot.at = mean_outline(camera, scratch.seen, sphere) + fitted->shift + fitted->sigma_px * normal;
        part.spot.sigma_px = fitted->sigma_px;
        part.spot.whole = fitted->share;
        const double narrower = 1.0 - options.outline.inside_px / std::sqrt(part.spot.area * std::numbers::inv_pi);
        part.spot.area *= narrower * narrower;
    } else {
        part.spot.at = mean_centre(camera, scratch.seen, sphere) + left.shift + sigma * normal;
    }
    scratch.parts.push_back(part);
}

/// A bright point that is a bell in the image: pixels above a threshold.
void add_point(const TrueCamera& camera, const Vec2& middle, double light, double sigma, const SpotOptions& options,
               double ambient, Rng& rng, SpotScratch& scratch) {
    if (light < options.least_light ||
        !(middle.x() > 0.0 && middle.y() > 0.0 && middle.x() < camera.width - 1 && middle.y() < camera.height - 1)) {
        return;
    }
    SpotScratch::Part part;
    const double radius2 = 2.0 * sigma * sigma * std::log(light / options.least_light);
    part.spot.area = std::max(1.0, std::floor(std::numbers::pi * radius2));
    part.radius = std::sqrt(radius2);
    part.light = 2.0 * std::numbers::pi * sigma * sigma * light;
    set_brightness(camera, ambient, light, part.spot);
    const double noise = centroid_sigma(camera.sensor, options.noise, 0.5 * light, part.radius);
    part.spot.at = middle + noise * Vec2(rng.normal(), rng.normal());
    scratch.parts.push_back(part);
}

void add_glints(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    for (const Glint& glint : seen.glints) {
        const Vec2 direction = glint.at.head<2>() / glint.at.z();
        if (glint.at.z() > 0.0 && direction.norm() < far_outside) {
            add_point(camera, distorted(camera.lens, direction), glint.light * glint_left(seen, glint), glint.sigma_px,
                      options, seen.ambient, rng, scratch);
        }
    }
}

void add_specks(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    const double least = std::exp(-seen.specks);
    for (double product = rng.uniform(); product > least; product *= rng.uniform()) {
        const Speck speck = draw_speck(camera.width, camera.height, rng);
        add_point(camera, speck.at, speck.light, speck.sigma_px, options, seen.ambient, rng, scratch);
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
            if ((parts[i].spot.at - parts[j].spot.at).squaredNorm() >= reach * reach) {
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
    for (int i = 0; i < static_cast<int>(instants[0].spheres.size()); ++i) {
        add_sphere(camera, i, options, rng, scratch);
    }
    add_glints(camera, options, rng, scratch);
    add_specks(camera, options, rng, scratch);
    merge_touching(options.gap_px, scratch.parts);
    std::sort(scratch.parts.begin(), scratch.parts.end(), [](const SpotScratch::Part& a, const SpotScratch::Part& b) {
        return a.spot.at.y() - a.radius < b.spot.at.y() - b.radius;
    });
    spots.clear();
    scratch.sphere_of.clear();
    for (SpotScratch::Part& part : scratch.parts) {
        const Vec2& middle = part.spot.at;
        part.spot.at_rim = middle.x() < part.radius || middle.y() < part.radius ||
                           middle.x() > camera.width - 1 - part.radius || middle.y() > camera.height - 1 - part.radius;
        spots.push_back(part.spot);
        scratch.sphere_of.push_back(part.sphere);
    }
}

}  // namespace rhexis::tracking::synthetic
