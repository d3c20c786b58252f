// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <filesystem>

#include "base/output_file.hpp"
#include "failure_support.hpp"
#include "support/sanitized.hpp"
#include "tracking/json_fields.hpp"
#include "tracking/measure/measured_parts.hpp"

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

/// Two seeds, of which the second is worse.
std::vector<SeedNumbers> two_seeds() {
    return {{101,
             {{"images.tip_mm", {0.010, 0.014}},
              {"hidden.seen", {1.0, 1.0}},
              {"identity.wrong", {0.0, 0.0}},
              {"identity.exposures", {20000.0, 5000.0}},
              {"images.by3.tip_mm", {0.02}}}},
            {102,
             {{"images.tip_mm", {0.030, 0.026}},
              {"hidden.seen", {1.0, 0.0}},
              {"identity.wrong", {1.0}},
              {"identity.exposures", {20000.0}}}}};
}

const Figure& figure_named(const TrackingFigures& figures, const std::string& quantity) {
    const auto found = std::find_if(figures.figures.begin(), figures.figures.end(),
                                    [&quantity](const Figure& figure) { return figure.quantity == quantity; });
    REQUIRE(found != figures.figures.end());
    return *found;
}

std::string scratch_folder(const char* name) {
    const std::string folder = (std::filesystem::temp_directory_path() / name).string();
    std::filesystem::remove_all(folder);
    return folder;
}

}  // namespace

TEST_CASE("tips are told of instruments, after a start, for all exposures and by how many cameras saw them") {
    MarkerBody head;
    head.name = "head";
    MarkerBody tool;
    tool.name = "tool";
    ClipRun run;
    run.traces = {
        {sample(0.2, 900, 6)},
        {sample(0.05, 500, 6), sample(0.2, 10, 2), sample(0.3, 20, 6), sample(0.4, 40, 2), sample(0.5, 0, 0)}};
    Numbers numbers;
    add_tips({head, tool}, run, "row", numbers);
    CHECK(numbers["row.seen"] == std::vector<double>{1.0, 1.0, 1.0, 0.0});
    CHECK(numbers["row.tip_mm"].size() == 3);
    CHECK(figures_of(numbers["row.tip_mm"], 4).worst == doctest::Approx(0.04));
    CHECK(figures_of(numbers["row.by2.tip_mm"], 2).mean == doctest::Approx(0.025));
    CHECK(row_of(numbers, "row.by5.tip_mm").empty());
}

TEST_CASE("figures are of all seeds together, with their mean and the seed that is worst beside it") {
    const TrackingFigures figures = figures_from(two_seeds());
    const Figure& tip = figure_named(figures, "tip, six cameras, mean");
    CHECK(tip.value == doctest::Approx(20.0));
    CHECK(tip.mean == doctest::Approx(20.0));
    CHECK(tip.worst == doctest::Approx(28.0));
    CHECK(tip.worst_seed == 102);
    CHECK(tip.met());
    const Figure& valid = figure_named(figures, "valid poses under scripted occlusion");
    CHECK(valid.value == doctest::Approx(75.0));
    CHECK(valid.worst == doctest::Approx(50.0));  // more is better
    CHECK_FALSE(valid.met());
    const Figure& wrong = figure_named(figures, "bodies taken for another");
    CHECK(wrong.value == 1.0);
    CHECK(wrong.samples == 45000);
    CHECK_FALSE(wrong.met());
    const std::string text = figures_markdown(figures);
    CHECK(text.find("| tip, six cameras, mean | 20 um | 20 | 28 (102) | <= 20 | met |") != std::string::npos);
    CHECK(text.find("| 75 % | 75 | 50 (102) | >= 99.9 | not met |") != std::string::npos);
    CHECK(text.find("\n| 3 | images | 20 |") != std::string::npos);
    CHECK(text.find("\n| 4 | images") == std::string::npos);  // nothing was seen by four
    CHECK(text.find("calibration") == std::string::npos);     // nor measured
    const Json json = Json::parse(figures_json(figures), nullptr, false);
    REQUIRE(json.is_object());
    CHECK(json["figures"].size() == figures.figures.size());
    const auto tip_of_images = std::find_if(json["levels"].begin(), json["levels"].end(),
                                            [](const Json& level) { return level["quantity"] == "tip, six cameras"; });
    REQUIRE(tip_of_images != json["levels"].end());
    CHECK((*tip_of_images)["samples"] == 4);
    CHECK((*tip_of_images)["quantiles"][0][1] == 10.0);
}

TEST_CASE("how a quantity spreads is told by size, its mean with the sign, and no finer than there are samples") {
    Numbers numbers;
    for (int i = 1; i <= 100; ++i) {
        numbers["artifact.distance_mm"].push_back(i <= 50 ? -1e-3 * i : 1e-3 * i);
    }
    const Spread spread = figures_from({{1, numbers}}).standards[0];
    CHECK(spread.mean == doctest::Approx(25.0));
    CHECK(spread.at[0] == doctest::Approx(50.0));
    CHECK(spread.at[3] == doctest::Approx(99.0));
    CHECK(spread.at[5] == doctest::Approx(100.0));
    CHECK(spread.curve.back().share == doctest::Approx(0.99));
}

TEST_CASE("parts that are kept are read as they were, and refused where they are of another plan or spoilt") {
    const std::string folder = scratch_folder("rhexis-kept-parts");
    {
        const Result<KeptParts> kept = KeptParts::open(folder);
        REQUIRE(kept.ok());
        CHECK_FALSE(kept.value().read(7, "images", "1 s").value());
        const Numbers numbers{{"one", {0.25, -3e-7}}, {"none", {}}};
        REQUIRE(kept.value().write(7, "images", "1 s", numbers).ok());
        CHECK(kept.value().read(7, "images", "1 s").value() == numbers);
        const Result<std::optional<Numbers>> other = kept.value().read(7, "images", "2 s");
        REQUIRE_FALSE(other.ok());
        CHECK(other.error().text().find("7-images.json") != std::string::npos);
        REQUIRE(write_file(folder + "/8-images.json", "{\"plan\": \"1 s\", \"numbers\": {\"a\": 3").ok());
        CHECK_FALSE(kept.value().read(8, "images", "1 s").ok());
        REQUIRE(write_file(folder + "/9-images.json", R"({"plan": "1 s", "numbers": {"a": ["b"]}})").ok());
        CHECK_FALSE(kept.value().read(9, "images", "1 s").ok());
    }
    std::filesystem::remove_all(folder);
}

TEST_CASE("a plan out of range is refused and named") {
    const auto none = [](double, std::string_view) {};
    MeasurePlan plan;
    plan.seeds = 0;
    const Result<TrackingFigures> no_seeds = measure_tracking(plan, none);
    REQUIRE_FALSE(no_seeds.ok());
    CHECK(no_seeds.error().text().find("seeds") != std::string::npos);
    plan.seeds = 1;
    plan.image_s = 0.0;
    const Result<TrackingFigures> no_images = measure_tracking(plan, none);
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
