// SPDX-License-Identifier: GPL-3.0-or-later
// session -> virtual surgeon: what someone at the microscope can see and feel, before that person's delay and noise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// A structure that shows in the picture. Depth along the view is seen less well than position across it.
struct Landmark {
    std::string name;  ///< "pupil", "lens_front", "groove_floor", ...
    bool visible = false;
    Vec3 position = Vec3::Zero();  ///< where it appears [mm]
    double size = 0.0;             ///< radius or extent, where it has one [mm]
};

struct PerceivedTool {
    std::string name;
    bool present = false;
    Pose pose;
};

/// What the microscope shows, where the scene names one.
struct PerceivedField {
    Vec3 position = Vec3::Zero();  ///< in its middle and in focus; how high that is, only the foot that moves it knows
    double radius = 0.0;           ///< [mm]
    double out_of_focus = 0.0;     ///< how far the pupil is beyond the depth of field; 0: sharp [mm]
};

struct Percept {
    double time_s = 0.0;
    std::vector<PerceivedTool> tools;
    std::vector<Landmark> landmarks;
    std::optional<PerceivedField> field;
    double tip_brightness = 0.0;     ///< red-reflex luminance around the tip over the pupil, 0 dark to 1
    double reflex_brightness = 0.0;  ///< mean over the pupil
    double pedal = 0.0;              ///< machine panel
    double power = 0.0;              ///< machine panel, share of full power
    double vacuum_mmhg = 0.0;        ///< machine panel
    double flow_ml_min = 0.0;        ///< machine panel
};

}  // namespace rhexis
