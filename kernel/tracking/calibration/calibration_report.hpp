// SPDX-License-Identifier: GPL-3.0-or-later
// How good a calibration is, as a page for the person who did it.
#pragma once

#include <string>
#include <vector>

#include "tracking/calibration/coverage.hpp"
#include "tracking/calibration/wand.hpp"

namespace rhexis::tracking {

struct CalibrationGoals {
    double residual_px = 0.05;
    double scale_sigma = 2e-4;  ///< as a share
    double seconds = 1.0;
    double coverage = 0.6;        ///< share of each image's cells
    double dropped_frames = 0.1;  ///< share of all
    double lens_residual_px = 0.1;
    double lens_focal_sigma = 1e-3;  ///< as a share
    double lens_coverage = 0.8;
    int lens_views = 12;
};

struct CalibrationReport {
    std::string title{};               ///< the rig's name and the day, as a person wrote them
    WandCalibration wand{};            ///< its rig is what is drawn
    std::vector<Coverage> coverage{};  ///< of each camera's image by the wand
    CalibrationGoals goals{};
};

/// Coverage by the wand, of each of the rig's cameras.
std::vector<Coverage> wand_coverage(const Rig& rig, std::span<const WandFrame> frames);

/// What to do about figures that miss their goal, a sentence each; none: all are met.
std::vector<std::string> calibration_advice(const CalibrationReport& report);

/// Likewise of lenses, with the camera's name; none also where Rig::lenses are not told.
std::vector<std::string> lens_advice(const Rig& rig, const CalibrationGoals& goals = {});

/// A page like calibration_page() of lenses alone, whose cameras' places are still to be found.
std::string lens_page(const std::string& title, const Rig& rig, const CalibrationGoals& goals = {});

/// One page of HTML that needs no other file: figures beside their goals, what to do where one is missed, residuals
/// and coverage of each camera, what is known of the lenses, and the rig from above with what the cameras see. All text
/// is escaped.
std::string calibration_page(const CalibrationReport& report);

}  // namespace rhexis::tracking
