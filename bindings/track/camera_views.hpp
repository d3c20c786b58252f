// SPDX-License-Identifier: GPL-3.0-or-later
// What a window shows of tracking: what each camera sees, each body on a line, how the rig is. And of a calibration:
// where each camera has seen the wand.
#pragma once

#include "track/status.hpp"
#include "tracking/annotated.hpp"
#include "tracking/calibration/rig_calibration.hpp"
#include "trial/picture_screen.hpp"

namespace rhexis::tracking {

/// One set of exposures and all that was made of it; a copy, for whoever draws it meanwhile.
struct TrackingView {
    SeenByCameras seen{};
    TrackedBodies told{};
    RigHealth health{};
};

/// As a window wishes it. One picture that is wanted alone is the only one that is drawn.
ScreenMoment moment_of(const Setup& setup, const TrackingView& view, const ScreenWish& wish);

inline constexpr const char* wand_advice = "wave the wand everywhere";

/// What was seen of a wand; a copy likewise.
struct CalibrationView {
    double share = 0.0;  ///< of the time
    SeenByCameras seen{};
    std::vector<Coverage> coverage{};  ///< of each camera's image
    std::vector<int> views{};          ///< exposures in which it saw the whole wand, by camera
};
CalibrationView view_of(const Rig& rig, const WandLook& look);

ScreenMoment moment_of(const Setup& setup, const CalibrationView& view, const ScreenWish& wish);

}  // namespace rhexis::tracking
