// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/figures.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "tracking/measure/centroid_errors.hpp"
#include "tracking/measure/detector_chart.hpp"
#include "tracking/measure/figure_samples.hpp"

namespace rhexis::tracking {
namespace {

constexpr double um = 1e3;  // in a millimetre

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    return values[std::min(index, values.size() - 1)];
}

Status add_centroids(const MeasurePlan& plan, std::vector<Figure>& figures) {
    for (const auto& [name, low, high] :
         {std::tuple("centroid, images 5 to 14 px wide", 5.0, 14.0), std::tuple("centroid, 18 to 24 px", 18.0, 24.0)}) {
        std::int64_t samples = 0;
        double squares = 0.0;
        for (int part = 0; part < 4; ++part) {
            const Result<CentroidErrors> errors =
                measure_centroids(low + (high - low) * part / 3.0, 6, plan.first_seed, SpotSettings{});
            if (!errors) {
                return errors.error();
            }
            samples += errors.value().samples;
            squares += errors.value().rms_px * errors.value().rms_px * static_cast<double>(errors.value().samples);
        }
        figures.push_back({name, "px RMS each way", std::sqrt(squares / static_cast<double>(samples)), 0.02, false,
                           "0.02 to 0.03", samples, "images"});
    }
    return success();
}

void add_tips(const char* name, const ErrorFigures& errors, double mean, double of_95, double of_999,
              const char* published, const char* from, std::vector<Figure>& figures) {
    const std::string what = std::string("tip, ") + name;
    figures.push_back({what + ", mean", "um", um * errors.mean, mean, false, published, errors.valid, from});
    figures.push_back({what + ", 95 %", "um", um * errors.of_95, of_95, false, "", errors.valid, from});
    if (of_999 > 0.0) {
        figures.push_back({what + ", 99.9 %", "um", um * errors.of_999, of_999, false, "", errors.valid, from});
    }
}

ErrorFigures axis_errors_of(const std::vector<TipTrace>& traces) {
    TipTrace all;
    for (const TipTrace& trace : traces) {
        all.insert(all.end(), trace.begin(), trace.end());
    }
    return axis_errors(all);
}

double worst_of(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void add_calibration(const Samples& samples, std::vector<Figure>& figures) {
    std::vector<double> residuals;
    std::vector<double> scales;
    std::vector<double> seconds;
    for (const SyntheticCalibration& calibration : samples.calibrations) {
        residuals.push_back(calibration.wand_residual_px);
        scales.push_back(100.0 * std::abs(calibration.scale_error));
        seconds.push_back(calibration.seconds);
    }
    const auto count = static_cast<std::int64_t>(residuals.size());
    figures.push_back({"calibration, residual, worst", "px RMS", worst_of(residuals), 0.05, false, "", count, "wand"});
    figures.push_back(
        {"calibration, scale error, worst", "%", worst_of(scales), 0.02, false, "0.02 (Bi 2021)", count, "wand"});
    figures.push_back({"calibration, adjustment, worst", "s", worst_of(seconds), 1.0, false, "", count, "wand"});
}

void add_knocks(const Samples& samples, std::vector<Figure>& figures) {
    double latest_s = 0.0;
    double false_alarms = 0.0;
    for (const KnockErrors& knock : samples.knocks) {
        latest_s = std::max(latest_s, knock.named_after_s);
        false_alarms += knock.false_alarms;
    }
    const auto count = static_cast<std::int64_t>(samples.knocks.size());
    figures.push_back({"knocked camera, named after, worst", "s", latest_s, 1.0, false, "", count, "markers"});
    figures.push_back(
        {"cameras named that were not knocked", "runs", false_alarms, 0, false, "", 2 * count, "markers"});
}

void add_figures(const Samples& samples, std::vector<Figure>& figures) {
    const auto waves = static_cast<std::int64_t>(samples.gains.size());
    const auto frames = static_cast<std::int64_t>(samples.frame_seconds.size());
    add_tips("six cameras", tip_errors_of(samples.images.traces), 20, 40, 100,
             "20 (CatAR, one marker, 2017), 24 a marker (Bi 2021, Sensors 21:2528)", "images", figures);
    add_tips("six cameras", tip_errors_of(samples.markers.traces), 20, 40, 100, "", "markers", figures);
    add_tips("three cameras left", tip_errors_of(samples.subsets[1].traces), 20, 40, 100, "", "images", figures);
    add_tips("two cameras left", tip_errors_of(samples.subsets[0].traces), 30, 60, 0, "", "images", figures);
    const ErrorFigures axis = axis_errors_of(samples.images.traces);
    figures.push_back({"axis, 95 %", "degrees", axis.of_95, 0.04, false, "", axis.valid, "images"});
    figures.push_back({"jitter at rest, six cameras", "um RMS, worst axis", um * mean_of(samples.still_six.jitters), 5,
                       false, "80 to 100 (NDI, control limits)", tip_errors_of(samples.still_six.traces).valid,
                       "images"});
    figures.push_back({"jitter at rest, two cameras", "um RMS, worst axis", um * mean_of(samples.still_two.jitters), 10,
                       false, "", tip_errors_of(samples.still_two.traces).valid, "images"});
    double gain_off = 0.0;
    for (const double gain : samples.gains) {
        gain_off = std::max(gain_off, std::abs(gain - 1.0));
    }
    figures.push_back(
        {"tremor 6 to 14 Hz, amplitude off by, worst wave", "%", 100.0 * gain_off, 10, false, "", waves, "markers"});
    figures.push_back(
        {"tremor 6 to 14 Hz, lag, worst wave", "ms", um * worst_of(samples.lags_s), 8, false, "", waves, "markers"});
    const ErrorFigures moving = tip_errors_of(samples.moving.traces);
    figures.push_back({"up to 100 mm/s, cameras 5 ms apart, 95 %", "um", um * moving.of_95, 100, false,
                       "94 a marker, dynamic (Bi 2021)", moving.valid, "markers"});
    const ErrorFigures occlusion = tip_errors_of(samples.occlusion.traces);
    figures.push_back({"valid poses under scripted occlusion", "%",
                       100.0 * static_cast<double>(occlusion.valid) /
                           static_cast<double>(std::max<std::int64_t>(occlusion.frames, 1)),
                       99.9, true, "", occlusion.frames, "markers"});
    figures.push_back({"found again after, worst", "exposures", worst_of(samples.reacquired), 2, false, "",
                       static_cast<std::int64_t>(samples.reacquired.size()), "markers"});
    figures.push_back({"wrong or false bodies", "exposures", static_cast<double>(samples.wrong), 0, false, "",
                       samples.identity_frames, "markers"});
    figures.push_back({"six images to poses, one core, p50", "ms", um * quantile(samples.frame_seconds, 0.5), 2, false,
                       "", frames, "images"});
    figures.push_back({"six images to poses, one core, p99", "ms", um * quantile(samples.frame_seconds, 0.99), 4, false,
                       "", frames, "images"});
    add_calibration(samples, figures);
    add_knocks(samples, figures);
}

void add_by_cameras(const Samples& samples, TrackingFigures& result) {
    std::vector<TipTrace> images = samples.images.traces;
    for (const Gathered& subset : samples.subsets) {
        images.insert(images.end(), subset.traces.begin(), subset.traces.end());
    }
    std::vector<TipTrace> markers = samples.markers.traces;
    markers.insert(markers.end(), samples.occlusion.traces.begin(), samples.occlusion.traces.end());
    for (int cameras = 2; cameras <= 6; ++cameras) {
        result.by_cameras.push_back({cameras, true, tip_errors_of(images, cameras)});
        result.by_cameras.push_back({cameras, false, tip_errors_of(markers, cameras)});
    }
}

Status check_plan(const MeasurePlan& plan) {
    if (Status status = check_range("seeds", plan.seeds, 1, 100, "measuring"); !status) {
        return status;
    }
    if (Status status = check_range("image_s", plan.image_s, 0.2, 10, "measuring"); !status) {
        return status;
    }
    if (Status status = check_range("marker_s", plan.marker_s, 0.2, 20, "measuring"); !status) {
        return status;
    }
    return check_range("identity_frames", plan.identity_frames, 0, 1e8, "measuring");
}

}  // namespace

ErrorFigures tip_errors_of(const std::vector<TipTrace>& traces, int cameras) {
    TipTrace all;
    for (const TipTrace& trace : traces) {
        for (const TipSample& sample : trace) {
            if (cameras == 0 || (sample.seen && sample.cameras == cameras)) {
                all.push_back(sample);
            }
        }
    }
    return tip_errors(all);
}

Result<TrackingFigures> measure_tracking(const MeasurePlan& plan, const MeasureProgress& progress) {
    if (const Status status = check_plan(plan); !status) {
        return status.error();
    }
    TrackingFigures result;
    result.first_seed = plan.first_seed;
    result.seeds = plan.seeds;
    Samples samples;
    samples.subsets.resize(2);
    progress("centroids");
    if (const Status status = add_centroids(plan, result.figures); !status) {
        return status.error();
    }
    for (int i = 0; i < plan.seeds; ++i) {
        const std::uint64_t seed = plan.first_seed + static_cast<std::uint64_t>(i);
        progress("seed " + std::to_string(seed) + ": calibration");
        const Result<Setting> setting = setting_of(plan, seed, samples);
        if (!setting) {
            return setting.error();
        }
        if (const Status status = measure_seed(setting.value(), progress, samples); !status) {
            return status.error();
        }
        if (plan.chart && i == 0) {
            progress("detectors");
            Result<std::vector<ChartRow>> chart = detector_chart(setting.value().rig, setting.value().solver, seed, 24);
            if (!chart) {
                return chart.error();
            }
            result.chart = std::move(chart).value();
        }
    }
    add_figures(samples, result.figures);
    add_by_cameras(samples, result);
    return result;
}

}  // namespace rhexis::tracking
