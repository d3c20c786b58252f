// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of numbers that come from outside.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis {

/// A number as short as it reads ("0.05", "24000").
std::string short_number(double value);

/// "field is 12 (3 to 9)" for a value outside [minimum, maximum] or not a number.
Status check_range(const std::string& field, double value, double minimum, double maximum);

}  // namespace rhexis
