// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/spot_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "math/random_vectors.hpp"
#include "tracking/synthetic/diffuse_light.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr double far_outside = 1.0;  ///< |(X/Z, Y/Z)| where the lens's polynomials mean nothing any more

double lobe_mean(double lobe) { return 1.0 - 0.5 * lobe; }

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

void set_brightness(const TrueCamera& camera, double ambient, double light, Spot& spot) {
    const Sensor& sensor = camera.sensor;
    const double noise = std::sqrt(sensor.read_noise * sensor.read_noise + light / sensor.electrons);
    const double brightest = sensor.black + ambient + light + 2.0 * noise;
    spot.peak = std::min(255.0, std::floor(brightest + 0.5));
    spot.clipped = brightest >= 255.0;
}

/// A bright point that is a bell in the image: pixels above a threshold.
void add_point(const TrueCamera& camera, const Vec2& middle, double light, double sigma, const SpotOptions& options,
               double ambient, Rng& rng, SpotScratch& scratch) {
    const double least_light = least_light_of(camera, options, ambient);
    if (light < least_light ||
        !(middle.x() > 0.0 && middle.y() > 0.0 && middle.x() < camera.width - 1 && middle.y() < camera.height - 1)) {
        return;
    }
    SpotScratch::Part part;
    const double radius2 = 2.0 * sigma * sigma * std::log(light / least_light);
    part.spot.area = std::max(1.0, std::floor(std::numbers::pi * radius2));
    if (options.centre == SpotCentre::outline && part.spot.area < options.finder.least_area) {
        return;
    }
    part.radius = std::sqrt(radius2);
    part.light = 2.0 * std::numbers::pi * sigma * sigma * light;
    set_brightness(camera, ambient, light, part.spot);
    const double noise = centroid_sigma(camera.sensor, options.noise, 0.5 * light, part.radius);
    part.spot.at = middle + noise * normal2(rng);
    scratch.parts.push_back(part);
}

}  // namespace

bool shows_wear(const Sphere& seen) {
    constexpr double edge = 0.05;  // the patch's edge is soft
    const double sine = std::sqrt(std::max(0.0, 1.0 - seen.worn_cosine * seen.worn_cosine)) + edge;
    return seen.worn_cosine <= 1.0 && -seen.worn_towards.dot(seen.centre.normalized()) > -sine;
}

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

double centroid_sigma(const Sensor& sensor, const CentroidNoise& noise, double light, double radius) {
    constexpr double rounding = 1.0 / 12.0;
    const double variance = sensor.read_noise * sensor.read_noise + light / sensor.electrons + rounding;
    const double wider = 1.0 + noise.rim_px / radius;
    const double shot = 0.5 * std::sqrt(variance * std::numbers::inv_pi) / light * wider * wider;
    return std::hypot(noise.floor_px, noise.shot * shot);
}

double light_of_middle(const TrueCamera& camera, const Sphere& seen) {
    const double distance2 = seen.centre.squaredNorm() / (light_at_mm * light_at_mm);
    return seen.light / distance2 * sensitivity(camera.optics, seen.centre.head<2>() / seen.centre.z());
}

SpotScratch::Part part_of(const TrueCamera& camera, int sphere, const Left& left, const SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    const Sphere& it = seen.spheres[at(sphere)];
    const Outline ellipse = outline(it);
    const double focal = std::sqrt(distortion_slope(camera.lens, it.centre.head<2>() / it.centre.z()).determinant());
    const double moved = smear(camera, scratch.seen, sphere).norm();
    const double spread_share = 0.5 * std::sqrt(lobe_spread(it.lobe));
    const double least = focal * ellipse.across * spread_share * left.least;
    const double greatest = std::hypot(focal * ellipse.along * spread_share * left.greatest, moved / std::sqrt(12.0));
    const double middle_light = light_of_middle(camera, it);
    SpotScratch::Part part;
    part.sphere = sphere;
    part.radius = focal * ellipse.along;
    part.spot.area = std::numbers::pi * focal * focal * ellipse.along * ellipse.across * left.share +
                     2.0 * focal * ellipse.across * moved;
    part.spot.roundness = std::min(1.0, least / greatest);
    part.light = middle_light * lobe_mean(it.lobe) * left.light / left.share *
                 (part.spot.area / (part.spot.area + focal * ellipse.across * moved)) * part.spot.area;
    set_brightness(camera, seen.ambient, middle_light * left.light / left.share, part.spot);
    return part;
}

double radius_of(const Spot& spot) { return std::sqrt(spot.area * std::numbers::inv_pi); }

double least_light_of(const TrueCamera& camera, const SpotOptions& options, double ambient) {
    return options.centre == SpotCentre::light ? options.least_light
                                               : options.finder.threshold - camera.sensor.black - ambient;
}

bool is_left(const TrueCamera& camera, int sphere, const SpotOptions& options, SpotScratch& scratch, Left& left) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    const Sphere& it = seen.spheres[at(sphere)];
    find_hiders(seen, sphere, scratch.hiders);
    if (!scratch.hiders.none() || shows_wear(it)) {
        left = what_is_left(camera, seen, sphere, scratch);
    }
    return left.share >= options.least_share &&
           light_of_middle(camera, it) * left.light / left.share >= least_light_of(camera, options, seen.ambient);
}

std::optional<Vec2> glint_image(const TrueCamera& camera, const Glint& glint) {
    const Vec2 direction = glint.at.head<2>() / glint.at.z();
    return glint.at.z() > 0.0 && direction.norm() < far_outside ? std::optional<Vec2>(distorted(camera.lens, direction))
                                                                : std::nullopt;
}

void add_glint(const TrueCamera& camera, const Glint& glint, const SpotOptions& options, Rng& rng,
               SpotScratch& scratch) {
    const Scene& seen = scratch.seen[scratch.seen.size() / 2];
    if (const std::optional<Vec2> image = glint_image(camera, glint)) {
        add_point(camera, *image, glint.light * glint_left(seen, glint), glint.sigma_px, options, seen.ambient, rng,
                  scratch);
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

}  // namespace rhexis::tracking::synthetic
