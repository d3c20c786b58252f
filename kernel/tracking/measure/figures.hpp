// SPDX-License-Identifier: GPL-3.0-or-later
// What tracking reaches on the synthetic rig, beside what was aimed at and what others publish.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "tracking/measure/tip_errors.hpp"

namespace rhexis::tracking {

struct MeasurePlan {
    std::uint64_t first_seed = 101;  ///< rig, calibration, clip and noise are drawn by it
    int seeds = 4;                   ///< 1 to 100
    double image_s = 0.5;            ///< of each clip that is rendered, at 120 exposures a second
    double marker_s = 4.0;           ///< of moving clips without images; the others are measured whole
    int identity_frames = 20000;     ///< in which bodies are looked for wrongly told ones
    bool chart = true;               ///< detectors, cameras and markers against compute
};

/// One quantity of the table.
struct Figure {
    std::string quantity{};
    std::string unit{};
    double value = 0.0;
    double goal = 0.0;  ///< at most this; of shares at least this
    bool at_least = false;
    std::string published{};  ///< by others, with the key of its source
    std::int64_t samples = 0;
    std::string from{};  ///< clips, images or markers

    [[nodiscard]] bool met() const { return at_least ? value >= goal : value <= goal; }
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
    std::vector<Figure> figures{};
    std::vector<CamerasFigures> by_cameras{};
    std::vector<ChartRow> chart{};
};

/// Told before each part: what is measured now.
using MeasureProgress = std::function<void(std::string_view what)>;

/// All of it, with rigs that were calibrated by boards and a waved wand. The error names what of the plan is out of
/// range, or is a calibration's.
Result<TrackingFigures> measure_tracking(const MeasurePlan& plan, const MeasureProgress& progress);

/// Every figure of one kind of error of several traces, in one; `cameras`: only exposures that so many saw, 0: all.
ErrorFigures tip_errors_of(const std::vector<TipTrace>& traces, int cameras = 0);

/// As tables of a text.
std::string figures_markdown(const TrackingFigures& figures);
/// {"seeds": [...], "figures": [...], "by_cameras": [...], "chart": [...]}; lengths in mm, times in s.
std::string figures_json(const TrackingFigures& figures);

}  // namespace rhexis::tracking
