// SPDX-License-Identifier: GPL-3.0-or-later
// What tracking reaches on the synthetic rig, beside what was aimed at and what others publish.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "tracking/measure/kept_parts.hpp"
#include "tracking/measure/tip_errors.hpp"

namespace rhexis::tracking {

struct MeasurePlan {
    std::uint64_t first_seed = 101;  ///< rig, calibration, clip and noise are drawn by it
    int seeds = 4;                   ///< 1 to 100
    int marker_seeds = 0;            ///< likewise, of parts that render nothing; at least `seeds` are measured
    double image_s = 0.5;            ///< of each clip that is rendered, at 120 exposures a second, 0.2 to 10
    double marker_s = 4.0;           ///< of hands that go fast, without images; 0.2 to 20
    int identity_frames = 20000;     ///< in which bodies are looked for wrongly told ones, of all seeds together
    bool chart = true;               ///< detectors, cameras and markers against compute
    std::string keep{};              ///< folder for what each part of each seed gave; empty: it is not kept
};

/// One quantity of the table.
struct Figure {
    std::string quantity{};
    std::string unit{};
    double value = 0.0;  ///< of all seeds' samples together
    double mean = 0.0;   ///< of what each seed alone gives
    double worst = 0.0;  ///< of the seed that is farthest from the goal
    std::uint64_t worst_seed = 0;
    std::optional<double> goal{};  ///< at most this; of shares at least this
    bool at_least = false;
    std::string published{};  ///< by others, with the key of its source
    std::int64_t samples = 0;
    std::string from{};  ///< clips, images or markers

    [[nodiscard]] bool met() const { return !goal || (at_least ? value >= *goal : value <= *goal); }
};

/// How a quantity spreads, of all seeds together.
struct Spread {
    static constexpr std::array<double, 6> shares{0.5, 0.9, 0.95, 0.99, 0.999, 1.0};

    std::string quantity{};
    std::string unit{};
    std::string from{};  ///< images or markers
    std::int64_t samples = 0;
    double mean = 0.0;  ///< with its sign
    double rms = 0.0;
    std::array<double, 6> at{};  ///< so many of the samples are no farther from 0
    struct Quantile {
        double share = 0.0;
        double value = 0.0;
    };
    std::vector<Quantile> curve{};  ///< the same, finer to the end, for charts
};

/// Tip errors in exposures in which this many cameras saw the instrument [mm].
struct CamerasFigures {
    int cameras = 0;
    bool images = false;
    ErrorFigures tip{};
};

/// One way to detect, with some of the cameras and markers.
struct ChartRow {
    std::string detector{};
    int cameras = 6;
    int markers = 4;
    ErrorFigures tip{};         ///< [mm]
    double detect_p50_s = 0.0;  ///< of all these cameras' images, one core
    double track_p50_s = 0.0;
};

struct TrackingFigures {
    std::uint64_t first_seed = 0;
    int seeds = 0;
    int marker_seeds = 0;
    std::vector<Figure> figures{};
    std::vector<CamerasFigures> by_cameras{};
    std::vector<Spread> levels{};     ///< with and without images, of the same clips
    std::vector<Spread> standards{};  ///< in the terms of standards
    std::vector<ChartRow> chart{};
};

/// Told before each part: the share of all parts that is done, and what is measured now.
using MeasureProgress = std::function<void(double share, std::string_view what)>;

/// All of it, with rigs that were calibrated by boards and a waved wand. A part that is kept is read, not measured. The
/// error names what of the plan is out of range, a kept file that is of another plan, or is a calibration's.
Result<TrackingFigures> measure_tracking(const MeasurePlan& plan, const MeasureProgress& progress);

/// One seed's numbers.
struct SeedNumbers {
    std::uint64_t seed = 0;
    Numbers numbers{};
};
/// What the parts of all seeds come to.
TrackingFigures figures_from(const std::vector<SeedNumbers>& seeds);

/// As tables of a text.
std::string figures_markdown(const TrackingFigures& figures);
/// {"first_seed", "seeds", "figures": [...], "by_cameras": [...], "levels": [...], "standards": [...], "chart": [...]};
/// lengths in mm, times in s; spreads in their own units.
std::string figures_json(const TrackingFigures& figures);

}  // namespace rhexis::tracking
