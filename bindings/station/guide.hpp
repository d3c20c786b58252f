// SPDX-License-Identifier: GPL-3.0-or-later
// The next thing that hands have to learn, until each has been done once in this attempt.
#pragma once

#include <optional>
#include <string>

#include "station/hands.hpp"
#include "station/words.hpp"

namespace rhexis::station {

class Guide {
public:
    /// What to do next, with the keys of the mapping; none: all has been done. That the clock waits for the hand is
    /// said each time.
    std::optional<std::string> next(const HandsState& hands, const Stand& stand, const Words& words);

private:
    bool took_ = false;
    bool went_in_ = false;
    bool changed_depth_ = false;
    bool pressed_pedal_ = false;
    bool squeezed_ = false;
    double entry_height_ = 0.0;
    double jaw_at_first_ = 0.0;
};

}  // namespace rhexis::station
