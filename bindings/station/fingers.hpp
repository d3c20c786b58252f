// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of a mapping: which keys, buttons and axes have to be worked so that hands do what they are to do. With
// it a virtual surgeon operates through the devices that people have.
#pragma once

#include <vector>

#include "flow/command.hpp"
#include "station/hands.hpp"

namespace rhexis::station {

/// With what the fingers work.
enum class Style {
    mouse,  ///< cursor, wheel, buttons and keys
    pad     ///< sticks, triggers and buttons, and a pedal
};

class Fingers {
public:
    /// width, height: of the window, whose pixels are the grain of a cursor. finely: a cursor's place is mended with
    /// the key for fine movements, in each step.
    Fingers(Style style, int width, int height, bool finely = true)
        : style_(style), width_(width), height_(height), finely_(finely) {}

    /// What to do so that, after the next step of dt [s], the hands are as near as they can be to these samples, which
    /// are of all instruments of the scene, and ask for what these commands ask for.
    std::vector<UserEvent> reach(const Hands& now, const Stand& stand, const std::vector<DeviceSample>& samples,
                                 const std::vector<Command>& commands, const Surroundings& around, double dt);

private:
    struct Work;
    Style style_;
    int width_;
    int height_;
    bool finely_;
    double pedal_before_ = 0.0;
};

}  // namespace rhexis::station
