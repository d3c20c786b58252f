// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/synthetic_rig.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "base/rng.hpp"
#include "math/rotation.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr std::array<double, 2> elevations_deg{30.0, 45.0};

Status check_options(const RigOptions& options) {
    struct Range {
        const char* name;
        double value;
        double low;
        double high;
    };
    const std::array<Range, 6> ranges{{{"cameras", static_cast<double>(options.cameras), 2, 16},
                                       {"distance_mm", options.distance_mm, 100, 2000},
                                       {"width", static_cast<double>(options.width), 64, 4096},
                                       {"height", static_cast<double>(options.height), 64, 4096},
                                       {"focal_px", options.focal_px, 100, 1e5},
                                       {"hot_pixels", static_cast<double>(options.hot_pixels), 0, 1000}}};
    for (const Range& range : ranges) {
        if (Status status = check_range(range.name, range.value, range.low, range.high, "synthetic rig"); !status) {
            return status;
        }
    }
    return success();
}

/// At `position`, looking at the origin, with the image's +y down.
Pose looking_at_origin(const Vec3& position) {
    Mat3 axes;
    axes.col(2) = -position.normalized();
    axes.col(0) = axes.col(2).cross(Vec3::UnitZ()).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return {position, Quat(axes)};
}

Camera nominal_camera(const RigOptions& options, int index) {
    const double around = 2.0 * std::numbers::pi * index / options.cameras;
    const double up =
        elevations_deg[static_cast<std::size_t>(index) % elevations_deg.size()] * std::numbers::pi / 180.0;
    Camera camera;
    camera.name = "camera" + std::to_string(index + 1);
    camera.width = options.width;
    camera.height = options.height;
    camera.lens.fx = options.focal_px;
    camera.lens.fy = options.focal_px;
    camera.lens.cx = 0.5 * (options.width - 1);
    camera.lens.cy = 0.5 * (options.height - 1);
    camera.pose = looking_at_origin(
        options.distance_mm * Vec3(std::cos(around) * std::cos(up), std::sin(around) * std::cos(up), std::sin(up)));
    return camera;
}

Vec3 normal_vector(Rng& rng) {
    const double x = rng.normal();
    const double y = rng.normal();
    return {x, y, rng.normal()};
}

TrueLens true_lens(const Lens& nominal, const RigSpread& spread, Rng& rng) {
    TrueLens lens;
    lens.fx = nominal.fx * (1.0 + spread.focal_share * rng.normal());
    lens.fy = lens.fx * (1.0 + 0.1 * spread.focal_share * rng.normal());
    lens.cx = nominal.cx + spread.centre_px * rng.normal();
    lens.cy = nominal.cy + spread.centre_px * rng.normal();
    const double share = spread.distortion;
    lens.k1 = share * (-0.11 + 0.01 * rng.normal());
    lens.k2 = share * (0.09 + 0.01 * rng.normal());
    lens.k3 = share * 0.03 * rng.normal();
    lens.p1 = share * 4e-4 * rng.normal();
    lens.p2 = share * 4e-4 * rng.normal();
    for (std::size_t i = 0; i < lens.s.size(); ++i) {
        lens.s[i] = share * (i % 2 == 0 ? 2e-4 : 5e-4) * rng.normal();
    }
    return lens;
}

std::vector<HotPixel> hot_pixels(const RigOptions& options, Rng& rng) {
    std::vector<HotPixel> hot;
    for (int i = 0; i < options.hot_pixels; ++i) {
        const auto x = static_cast<int>(rng.integer(0, options.width - 1));
        const auto y = static_cast<int>(rng.integer(0, options.height - 1));
        hot.push_back({x, y, 20.0 + 180.0 * rng.uniform()});
    }
    return hot;
}

TrueCamera true_camera(const Camera& nominal, const RigOptions& options, Rng& rng) {
    const RigSpread& spread = options.spread;
    TrueCamera camera;
    camera.name = nominal.name;
    camera.width = nominal.width;
    camera.height = nominal.height;
    camera.lens = true_lens(nominal.lens, spread, rng);
    camera.pose.position = nominal.pose.position + spread.position_mm * normal_vector(rng);
    camera.pose.orientation = turned(nominal.pose.orientation, spread.turn * normal_vector(rng));
    camera.optics = options.optics;
    camera.optics.psf_px += spread.distortion > 0.0 ? 0.1 * (rng.uniform() - 0.5) : 0.0;
    camera.sensor = options.sensor;
    camera.sensor.hot = hot_pixels(options, rng);
    camera.time_offset_s = spread.time_offset_s * rng.normal();
    return camera;
}

}  // namespace

Result<SyntheticRig> SyntheticRig::create(std::uint64_t seed, const RigOptions& options) {
    if (const Status status = check_options(options); !status) {
        return status.error();
    }
    SyntheticRig rig;
    for (int i = 0; i < options.cameras; ++i) {
        rig.nominal.cameras.push_back(nominal_camera(options, i));
        Rng rng(seed, "camera " + std::to_string(i));
        rig.cameras.push_back(true_camera(rig.nominal.cameras.back(), options, rng));
    }
    return rig;
}

Rig without_prism(const SyntheticRig& rig) {
    Rig result = rig.nominal;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        const TrueLens& lens = rig.cameras[i].lens;
        result.cameras[i].lens = {lens.fx, lens.fy, lens.cx, lens.cy, lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
        result.cameras[i].pose = rig.cameras[i].pose;
    }
    result.calibrated = true;
    return result;
}

}  // namespace rhexis::tracking::synthetic
