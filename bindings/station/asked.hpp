// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the staff in words, as a device of the tracking computer may do: a request of the exercise, or a
// dial of the machine.
#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "flow/command.hpp"
#include "station/stand.hpp"

namespace rhexis::station {

struct Asked {
    int request = -1;  ///< of the stand; -1: it is a dial
    int dial = -1;
    double value = 0.0;  ///< of the dial
};

/// Of a request's id or title, as in "bottle_down", or of a dial's setting and value, as in "machine.bottle_cm=60". The
/// error says what there is instead.
Result<Asked> what_is_asked(const Stand& stand, std::string_view text);

/// The words of a request or of a dial that was turned; empty: it is another command.
std::string words_of(const Command& command);

}  // namespace rhexis::station
