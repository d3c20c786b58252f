// SPDX-License-Identifier: GPL-3.0-or-later
// input -> tools: what a device, a recording or a virtual surgeon says an instrument does during one step.
#pragma once

#include "math/types.hpp"

namespace rhexis {

struct DeviceSample {
    int instrument = 0;    ///< index into the scene's instruments
    bool present = false;  ///< false: withdrawn from the scene
    Pose pose;             ///< of the instrument's tip; local +z points from the tip along the shaft to the hand [mm]
    double jaw = 0.0;      ///< opening, 0 closed to 1 open; cannula: how hard the hand presses
    double pedal = 0.0;    ///< foot pedal, 0 to 3; the fraction is the travel within the position
};

}  // namespace rhexis
