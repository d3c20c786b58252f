// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "failure_support.hpp"
#include "support/sanitized.hpp"
#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {
namespace {

/// So many micrometres off in x, seen by so many cameras; none: not seen.
TipSample sample(double time_s, double off_um, int cameras) {
    TipSample one;
    one.time_s = time_s;
    one.seen = cameras > 0;
    one.told.position = {1e-3 * off_um, 0.0, 0.0};
    one.cameras = cameras;
    return one;
}

TrackingFigures some_figures() {
    TrackingFigures figures;
    figures.first_seed = 101;
    figures.seeds = 2;
    figures.figures.push_back({"tip, mean", "um", 12.5, 20.0, false, "20 (somebody)", 300, "images"});
    figures.figures.push_back({"valid", "%", 99.0, 99.9, true, "", 300, "markers"});
    figures.by_cameras.push_back({3, true, figures_of({0.01, 0.03}, 2)});
    figures.by_cameras.push_back({4, true, {}});
    figures.chart.push_back({"outlines", 6, 4, figures_of({0.01}, 2), 1.5e-3, 2e-4});
    return figures;
}

}  // namespace

TEST_CASE("errors of several traces are told for all exposures, or for those that so many cameras saw") {
    const std::vector<TipTrace> traces{{sample(0.2, 10, 2), sample(0.3, 20, 6)},
                                       {sample(0.2, 40, 2), sample(0.3, 0, 0)}};
    const ErrorFigures all = tip_errors_of(traces);
    CHECK(all.frames == 4);
    CHECK(all.valid == 3);
    CHECK(all.worst == doctest::Approx(0.04));
    const ErrorFigures by_two = tip_errors_of(traces, 2);
    CHECK(by_two.valid == 2);
    CHECK(by_two.mean == doctest::Approx(0.025));
    CHECK(tip_errors_of(traces, 5).valid == 0);
}

TEST_CASE("a figure is met below its goal, or above where more is better, and tables say so") {
    const TrackingFigures figures = some_figures();
    CHECK(figures.figures[0].met());
    CHECK_FALSE(figures.figures[1].met());
    const std::string text = figures_markdown(figures);
    CHECK(text.find("| tip, mean | 12.5 um | <= 20 | met | 20 (somebody) | 300 | images |") != std::string::npos);
    CHECK(text.find("| valid | 99 % | >= 99.9 | not met |  | 300 | markers |") != std::string::npos);
    CHECK(text.find("| 3 | images | 20 |") != std::string::npos);
    CHECK(text.find("| 4 | images") == std::string::npos);  // nothing was seen by four
    CHECK(text.find("| outlines | 6 | 4 | 10 | 10 | 10 | 10 | 10 | 50 | 1.5 | 0.2 |") != std::string::npos);
    const std::string json = figures_json(figures);
    CHECK(json.find("\"quantity\": \"tip, mean\", \"unit\": \"um\", \"value\": 12.5") != std::string::npos);
    CHECK(json.find("\"met\": false") != std::string::npos);
    CHECK(std::count(json.begin(), json.end(), '{') == std::count(json.begin(), json.end(), '}'));
}

TEST_CASE("a plan out of range is refused and named") {
    MeasurePlan plan;
    plan.seeds = 0;
    const Result<TrackingFigures> none = measure_tracking(plan, [](std::string_view) {});
    REQUIRE_FALSE(none.ok());
    CHECK(none.error().text().find("seeds") != std::string::npos);
    plan.seeds = 1;
    plan.image_s = 0.0;
    const Result<TrackingFigures> no_images = measure_tracking(plan, [](std::string_view) {});
    REQUIRE_FALSE(no_images.ok());
    CHECK(no_images.error().text().find("image_s") != std::string::npos);
}

TEST_CASE("a calibration by boards and wand is as good as the wand, and as wrong as the wand is long" *
          doctest::skip(rhexis::testing::sanitized)) {
    const synthetic::SyntheticRig rig = synthetic::SyntheticRig::create(4).value();
    CalibrationPlan plan;
    plan.seed = 4;
    plan.boards = 18;
    plan.wand_frames = 200;
    const Result<SyntheticCalibration> right = calibrate_synthetic(rig, plan);
    REQUIRE(right.ok());
    CHECK(right.value().wand_residual_px < 0.05);
    CHECK(std::abs(right.value().scale_error) < 2e-4);
    CHECK(right.value().bend_mm < 0.01);
    plan.wand_error_mm = 0.2;  // of 200
    const Result<SyntheticCalibration> wrong = calibrate_synthetic(rig, plan);
    REQUIRE(wrong.ok());
    CHECK(wrong.value().scale_error - right.value().scale_error == doctest::Approx(-1e-3).epsilon(0.1));
}

TEST_CASE("the same spots are tracked alike again, and by some cameras only where asked") {
    const synthetic::Clip clip = testing::clip_named("circle");
    const auto recorded = record_spots(testing::workplace().rig, clip, testing::marker_plan(0.3)).value();
    REQUIRE(recorded.size() == 36);
    const auto two = only_cameras(recorded, {1, 4}, 0.1);
    CHECK(two[0].size() == 6);
    CHECK(two[35].size() == 2);
    CHECK(two[35][1].camera == 4);
    const auto run = [&clip](const std::vector<std::vector<CameraSpots>>& exposures) {
        RecordedSpots source(exposures, 120.0);
        return track_spots(source, testing::workplace().solver, clip, testing::marker_plan(1e9)).value();
    };
    const ClipRun once = run(recorded);
    CHECK(once.traces[1].back().told.position == run(recorded).traces[1].back().told.position);
    CHECK(once.traces[1].back().cameras > 2);
    CHECK(run(two).traces[1].back().cameras == 2);
}

}  // namespace rhexis::tracking
