// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/measured_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "tracking/measure/centroid_errors.hpp"
#include "tracking/measure/detector_chart.hpp"
#include "tracking/measure/knocks.hpp"
#include "tracking/measure/standard_tests.hpp"

namespace rhexis::tracking {
namespace {

Result<Numbers> calibration_numbers(const Setting& setting) {
    const SyntheticCalibration& calibration = setting.calibration;
    return Numbers{{"calibration.residual_px", {calibration.wand_residual_px}},
                   {"calibration.scale_percent", {100.0 * std::abs(calibration.scale_error)}},
                   {"calibration.bend_mm", {calibration.bend_mm}},
                   {"calibration.s", {calibration.seconds}}};
}

Result<Numbers> centroid_numbers(const Setting& setting) {
    constexpr int widths = 4;
    Numbers numbers;
    for (const auto& [name, low, high] : {std::tuple("small", 5.0, 14.0), std::tuple("wide", 18.0, 24.0)}) {
        std::vector<double>& errors = numbers[std::string("centroid.") + name + "_px"];
        for (int i = 0; i < widths; ++i) {
            const double width = low + (high - low) * i / (widths - 1.0);
            const Result<CentroidErrors> found = measure_centroids(width, 6, setting.seed, SpotSettings{});
            if (!found) {
                return found.error();
            }
            errors.insert(errors.end(), found.value().errors_px.begin(), found.value().errors_px.end());
            append({{std::string("centroid.") + name + "_bound_px", found.value().bounds_px}}, numbers);
        }
    }
    return numbers;
}

Result<Numbers> knocked_camera_numbers(const Setting& setting) {
    const Result<KnockErrors> errors = measure_knock(setting.rig, setting.solver(), setting.bodies, setting.seed);
    if (!errors) {
        return errors.error();
    }
    return Numbers{{"knocked.named_after_s", {errors.value().named_after_s}},
                   {"knocked.false", {static_cast<double>(errors.value().false_alarms)}}};
}

/// Chunks of it, each of which is kept: of a million exposures nothing is lost that took more than a minute.
void add_identity_parts(const MeasurePlan& plan, std::vector<Part>& parts) {
    constexpr int most_at_once = 20000;
    const int seeds = std::max(plan.seeds, plan.marker_seeds);
    const int of_seed = (plan.identity_frames + seeds - 1) / seeds;
    for (int number = 0; number * most_at_once < of_seed; ++number) {
        const int exposures = std::min(most_at_once, of_seed - number * most_at_once);
        parts.push_back(
            {"identity-" + std::to_string(number + 1), std::to_string(exposures) + " exposures", false,
             [number, exposures](const Setting& setting) { return measure_identity(setting, number, exposures); }});
    }
}

}  // namespace

ClipPlan Setting::clip_plan(bool images, double longest_s) const {
    ClipPlan result;
    result.seed = seed;
    result.images = images;
    result.longest_s = longest_s;
    return result;
}

Result<Setting> setting_of(const MeasurePlan& plan, std::uint64_t seed) {
    Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(seed);
    if (!rig) {
        return rig.error();
    }
    CalibrationPlan calibration;
    calibration.seed = seed;
    Result<SyntheticCalibration> calibrated = calibrate_synthetic(rig.value(), calibration);
    if (!calibrated) {
        return calibrated.error();
    }
    return Setting{plan, seed, std::move(rig).value(), std::move(calibrated).value(), synthetic::standard_bodies()};
}

std::vector<Part> measured_parts(const MeasurePlan& plan) {
    const std::string rendered = short_number(plan.image_s) + " s of images";
    const std::string moving = short_number(plan.marker_s) + " s of markers";
    std::vector<Part> parts{{"calibration", "", false, calibration_numbers},
                            {"centroids", "", true, centroid_numbers},
                            {"images", rendered, true, measure_images},
                            {"compute", "", true, measure_compute},
                            {"tremor", "", false, measure_tremor},
                            {"moving", moving, false, measure_moving},
                            {"hidden", "", false, measure_hidden},
                            {"found_again", "", false, measure_found_again},
                            {"knocked_camera", "", false, knocked_camera_numbers},
                            {"head", rendered + ", " + moving, true, measure_head},
                            {"artifact", rendered, true, measure_artifact},
                            {"phantom", "", true, measure_phantom}};
    if (plan.chart) {
        parts.push_back({"detectors", "", true, measure_detectors});
    }
    add_identity_parts(plan, parts);
    return parts;
}

void add_tips(const std::vector<MarkerBody>& bodies, const ClipRun& run, const std::string& name, Numbers& numbers) {
    constexpr double after_s = 0.1;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].name == "head") {  // told in the rig, whose frame is the calibration's
            continue;
        }
        for (const TipSample& sample : run.traces[i]) {
            if (sample.time_s < after_s) {
                continue;
            }
            numbers[name + ".seen"].push_back(sample.seen ? 1.0 : 0.0);
            if (sample.seen) {
                const double off_mm = (sample.told.position - sample.is.position).norm();
                numbers[name + ".tip_mm"].push_back(off_mm);
                numbers[name + ".by" + std::to_string(sample.cameras) + ".tip_mm"].push_back(off_mm);
                numbers[name + ".axis_deg"].push_back(axis_off_deg(sample));
            }
        }
    }
}

void add_jitters(const std::vector<MarkerBody>& bodies, const ClipRun& run, const std::string& name, Numbers& numbers) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (const double spread = jitter(run.traces[i]); bodies[i].name != "head" && std::isfinite(spread)) {
            numbers[name + ".jitter_mm"].push_back(spread);
        }
    }
}

}  // namespace rhexis::tracking
