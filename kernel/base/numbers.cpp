// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"

#include <cstdio>

namespace rhexis {

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string range_text(double minimum, double maximum, const std::string& unit) {
    return short_number(minimum) + " to " + short_number(maximum) + unit;
}

Status check_range(const std::string& field, double value, double minimum, double maximum, const std::string& where,
                   const std::string& unit) {
    if (value >= minimum && value <= maximum) {  // false for NaN
        return success();
    }
    return Error{field + " is " + short_number(value), where, range_text(minimum, maximum, unit)};
}

}  // namespace rhexis
