// SPDX-License-Identifier: GPL-3.0-or-later
// Which quantities there are, of which rows of numbers they are made, and what was aimed at.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracking/measure/detector_chart.hpp"
#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {
namespace {

using Row = std::vector<double>;

double mean_of(const Row& row) {
    return row.empty() ? 0.0 : std::accumulate(row.begin(), row.end(), 0.0) / static_cast<double>(row.size());
}
double root_mean_square(const Row& row) {
    return row.empty() ? 0.0
                       : std::sqrt(std::inner_product(row.begin(), row.end(), row.begin(), 0.0) /
                                   static_cast<double>(row.size()));
}
double sum_of(const Row& row) { return std::accumulate(row.begin(), row.end(), 0.0); }
double greatest(const Row& row) { return row.empty() ? 0.0 : *std::max_element(row.begin(), row.end()); }
template <int per_thousand>
double share_of_row(const Row& row) {
    return share_of(row, 1e-3 * per_thousand);
}

/// A quantity of a row of numbers: `of` it, times `scale`.
struct Quantity {
    const char* quantity;
    const char* unit;
    const char* row;
    double (*of)(const Row&);
    double scale;
    std::optional<double> goal;
    const char* from;
    const char* published = "";
    bool at_least = false;
    const char* counted = nullptr;  ///< row whose sum is the number of samples; else they are the row's
};

constexpr double um = 1e3;       // in a millimetre
constexpr double ms = 1e3;       // in a second
constexpr double percent = 1e2;  // in all

const std::vector<Quantity>& quantities() {
    static const std::vector<Quantity> all{
        {"centroid, images 5 to 14 px wide", "px RMS each way", "centroid.small_px", root_mean_square, 1, 0.02,
         "images", "0.02 to 0.03"},
        {"centroid, 18 to 24 px", "px RMS each way", "centroid.wide_px", root_mean_square, 1, 0.02, "images",
         "0.02 to 0.03"},
        {"centroid, what noise leaves to any finder, 5 to 14 px", "px RMS each way", "centroid.small_bound_px",
         root_mean_square, 1, std::nullopt, "images"},
        {"centroid, what noise leaves to any finder, 18 to 24 px", "px RMS each way", "centroid.wide_bound_px",
         root_mean_square, 1, std::nullopt, "images"},
        {"tip, six cameras, mean", "um", "images.tip_mm", mean_of, um, 20, "images",
         "20 (CatAR, one marker, 2017), 24 a marker (Bi 2021, Sensors 21:2528)"},
        {"tip, six cameras, 95 %", "um", "images.tip_mm", share_of_row<950>, um, 40, "images"},
        {"tip, six cameras, 99.9 %", "um", "images.tip_mm", share_of_row<999>, um, 100, "images"},
        {"tip, six cameras, mean", "um", "tremor.tip_mm", mean_of, um, 20, "markers"},
        {"tip, six cameras, 95 %", "um", "tremor.tip_mm", share_of_row<950>, um, 40, "markers"},
        {"tip, six cameras, 99.9 %", "um", "tremor.tip_mm", share_of_row<999>, um, 100, "markers"},
        {"tip, three cameras left, mean", "um", "three.tip_mm", mean_of, um, 20, "images"},
        {"tip, three cameras left, 95 %", "um", "three.tip_mm", share_of_row<950>, um, 40, "images"},
        {"tip, three cameras left, 99.9 %", "um", "three.tip_mm", share_of_row<999>, um, 100, "images"},
        {"tip, two cameras left, mean", "um", "two.tip_mm", mean_of, um, 30, "images"},
        {"tip, two cameras left, 95 %", "um", "two.tip_mm", share_of_row<950>, um, 60, "images"},
        {"axis, 95 %", "degrees", "images.axis_deg", share_of_row<950>, 1, 0.04, "images"},
        {"jitter at rest, six cameras", "um RMS, worst axis", "images.jitter_mm", mean_of, um, 5, "images",
         "80 to 100 (NDI, control limits)"},
        {"jitter at rest, two cameras", "um RMS, worst axis", "two.jitter_mm", mean_of, um, 10, "images"},
        {"tip, head breathing, mean", "um", "breathing.images.tip_mm", mean_of, um, 20, "images"},
        {"tip, head breathing, 95 %", "um", "breathing.images.tip_mm", share_of_row<950>, um, 40, "images"},
        {"tip, head breathing, mean", "um", "breathing.markers.tip_mm", mean_of, um, 20, "markers"},
        {"tip, head breathing, 95 %", "um", "breathing.markers.tip_mm", share_of_row<950>, um, 40, "markers"},
        {"tip, head breathing, 99.9 %", "um", "breathing.markers.tip_mm", share_of_row<999>, um, 100, "markers"},
        {"jitter, head breathing", "um RMS, worst axis", "breathing.markers.jitter_mm", mean_of, um, std::nullopt,
         "markers"},
        {"tip, head pushed by 1 mm, mean", "um", "knocks.images.tip_mm", mean_of, um, 20, "images"},
        {"tip, head pushed by 1 mm, 95 %", "um", "knocks.images.tip_mm", share_of_row<950>, um, 40, "images"},
        {"tip, head pushed by 1 mm, mean", "um", "knocks.markers.tip_mm", mean_of, um, 20, "markers"},
        {"tip, head pushed by 1 mm, 95 %", "um", "knocks.markers.tip_mm", share_of_row<950>, um, 40, "markers"},
        {"tip, head pushed by 1 mm, 99.9 %", "um", "knocks.markers.tip_mm", share_of_row<999>, um, 100, "markers"},
        {"jitter, head pushed by 1 mm", "um RMS, worst axis", "knocks.markers.jitter_mm", mean_of, um, std::nullopt,
         "markers"},
        {"tremor 6 to 14 Hz, amplitude off by, worst wave", "%", "tremor.gain_off", greatest, percent, 10, "markers"},
        {"tremor 6 to 14 Hz, lag, worst wave", "ms", "tremor.lag_s", greatest, ms, 8, "markers"},
        {"up to 100 mm/s, cameras 5 ms apart, 95 %", "um", "moving.tip_mm", share_of_row<950>, um, 100, "markers",
         "94 a marker, dynamic (Bi 2021)"},
        {"valid poses under scripted occlusion", "%", "hidden.seen", mean_of, percent, 99.9, "markers", "", true},
        {"found again after, worst", "exposures", "found_again.exposures", greatest, 1, 2, "markers"},
        {"bodies taken for another", "poses", "identity.wrong", sum_of, 1, 0, "markers", "", false,
         "identity.exposures"},
        {"bodies told that are not there", "poses", "identity.false", sum_of, 1, 0, "markers", "", false,
         "identity.exposures"},
        {"six images to poses, one core, p50", "ms", "compute.s", share_of_row<500>, ms, 2, "images"},
        {"six images to poses, one core, p99", "ms", "compute.s", share_of_row<990>, ms, 4, "images"},
        {"calibration, residual, worst", "px RMS", "calibration.residual_px", greatest, 1, 0.05, "wand"},
        {"calibration, scale error, worst", "%", "calibration.scale_percent", greatest, 1, 0.02, "wand",
         "0.02 (Bi 2021)"},
        {"calibration, adjustment, worst", "s", "calibration.s", greatest, 1, 1.0, "wand"},
        {"knocked camera, named after, worst", "s", "knocked.named_after_s", greatest, 1, 1.0, "markers"},
        {"cameras named that were not knocked", "runs", "knocked.false", sum_of, 1, 0, "markers"}};
    return all;
}

struct Spreading {
    const char* quantity;
    const char* unit;
    const char* row;
    double scale;
    const char* from;
};

const std::vector<Spreading>& level_rows() {
    static const std::vector<Spreading> all{{"centre of a spot", "px", "images.spot_px", 1, "images"},
                                            {"centre of a spot", "px", "markers.spot_px", 1, "markers"},
                                            {"noise of a spot at rest", "px", "images.noise_px", 1, "images"},
                                            {"noise of a spot at rest", "px", "markers.noise_px", 1, "markers"},
                                            {"tip, six cameras", "um", "images.tip_mm", um, "images"},
                                            {"tip, six cameras", "um", "markers.tip_mm", um, "markers"},
                                            {"jitter at rest", "um", "images.jitter_mm", um, "images"},
                                            {"jitter at rest", "um", "markers.jitter_mm", um, "markers"},
                                            {"spheres without a spot", "%", "images.missing", percent, "images"},
                                            {"spheres without a spot", "%", "markers.missing", percent, "markers"},
                                            {"spots not believed", "%", "images.refused", percent, "images"},
                                            {"spots not believed", "%", "markers.refused", percent, "markers"}};
    return all;
}

const std::vector<Spreading>& standard_rows() {
    static const std::vector<Spreading> all{
        {"E3064: distance between two bodies on a moving bar", "um", "artifact.distance_mm", um, "images"},
        {"E3064: turn between them", "degrees", "artifact.turn_deg", 1, "images"},
        {"F2554: middle point, bias", "um", "phantom.bias", um, "images"},
        {"F2554: middle point, precision", "um", "phantom.spread", um, "images"},
        {"F2554: middle point, pitch of 20 degrees each way", "um", "phantom.pitch", um, "images"},
        {"F2554: middle point, yaw of 20 degrees each way", "um", "phantom.yaw", um, "images"},
        {"F2554: middle point, roll of 60 degrees each way", "um", "phantom.roll", um, "images"},
        {"F2554: 20 points, after the best fit", "um", "phantom.point", um, "images"},
        {"F2554: distances between them", "um", "phantom.distance", um, "images"},
        {"E3124: images to poses, one core", "ms", "compute.s", ms, "images"},
        {"E3124: lag of what is told of trembling", "ms", "tremor.lag_s", ms, "markers"}};
    return all;
}

Numbers all_of(const std::vector<SeedNumbers>& seeds) {
    Numbers all;
    for (const SeedNumbers& seed : seeds) {
        append(seed.numbers, all);
    }
    return all;
}

Figure figure_of(const Quantity& quantity, const std::vector<SeedNumbers>& seeds, const Numbers& all) {
    Figure figure;
    figure.quantity = quantity.quantity;
    figure.unit = quantity.unit;
    figure.goal = quantity.goal;
    figure.at_least = quantity.at_least;
    figure.published = quantity.published;
    figure.from = quantity.from;
    const Row& row = row_of(all, quantity.row);
    figure.value = quantity.scale * quantity.of(row);
    figure.samples = quantity.counted != nullptr ? std::llround(sum_of(row_of(all, quantity.counted)))
                                                 : static_cast<std::int64_t>(row.size());
    double count = 0.0;
    for (const SeedNumbers& seed : seeds) {
        const Row& of_seed = row_of(seed.numbers, quantity.row);
        if (of_seed.empty()) {
            continue;
        }
        const double value = quantity.scale * quantity.of(of_seed);
        figure.mean += value;
        if (count == 0.0 || (quantity.at_least ? value < figure.worst : value > figure.worst)) {
            figure.worst = value;
            figure.worst_seed = seed.seed;
        }
        count += 1.0;
    }
    figure.mean /= std::max(count, 1.0);
    return figure;
}

Spread spread_of(const Spreading& spreading, const Numbers& all) {
    constexpr double decades = 4.0;
    constexpr int steps = 80;
    Spread spread{spreading.quantity, spreading.unit, spreading.from};
    Row row = row_of(all, spreading.row);
    spread.samples = static_cast<std::int64_t>(row.size());
    spread.mean = spreading.scale * mean_of(row);
    spread.rms = spreading.scale * root_mean_square(row);
    for (double& value : row) {
        value = spreading.scale * std::abs(value);
    }
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i < Spread::shares.size(); ++i) {
        spread.at[i] = share_of_sorted(row, Spread::shares[i]);
    }
    for (int i = 0; i <= steps; ++i) {
        const double beyond = std::pow(10.0, -decades * i / steps);
        if (beyond * static_cast<double>(row.size()) >= 1.0) {
            spread.curve.push_back({1.0 - beyond, share_of_sorted(row, 1.0 - beyond)});
        }
    }
    return spread;
}

ErrorFigures tips_by(const Numbers& all, const std::vector<const char*>& names, int cameras) {
    Row row;
    for (const char* name : names) {
        const Row& one = row_of(all, name + (".by" + std::to_string(cameras)) + ".tip_mm");
        row.insert(row.end(), one.begin(), one.end());
    }
    const auto count = static_cast<std::int64_t>(row.size());
    return figures_of(std::move(row), count);
}

}  // namespace

TrackingFigures figures_from(const std::vector<SeedNumbers>& seeds) {
    const Numbers all = all_of(seeds);
    TrackingFigures result;
    for (const Quantity& quantity : quantities()) {
        result.figures.push_back(figure_of(quantity, seeds, all));
    }
    for (int cameras = 2; cameras <= 6; ++cameras) {
        result.by_cameras.push_back({cameras, true, tips_by(all, {"images", "three", "two"}, cameras)});
        result.by_cameras.push_back({cameras, false, tips_by(all, {"tremor", "hidden"}, cameras)});
    }
    for (const Spreading& row : level_rows()) {
        result.levels.push_back(spread_of(row, all));
    }
    for (const Spreading& row : standard_rows()) {
        result.standards.push_back(spread_of(row, all));
    }
    result.chart = chart_rows(all);
    return result;
}

}  // namespace rhexis::tracking
