// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/numbers.hpp"

#include <cstdio>

namespace rhexis {

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

Status check_range(const std::string& field, double value, double minimum, double maximum) {
    if (value >= minimum && value <= maximum) {  // false for NaN
        return success();
    }
    return Error{field + " is " + short_number(value), "", short_number(minimum) + " to " + short_number(maximum)};
}

}  // namespace rhexis
