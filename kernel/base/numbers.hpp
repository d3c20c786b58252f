// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of numbers that come from outside.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis {

/// A number as short as it reads ("0.05", "24000").
std::string short_number(double value);

/// "3 to 9 mm"; unit with the blank before it, or empty.
std::string range_text(double minimum, double maximum, const std::string& unit = {});

/// "where: field is 12 (3 to 9 mm)" for a value outside [minimum, maximum] or not a number.
Status check_range(const std::string& field, double value, double minimum, double maximum,
                   const std::string& where = {}, const std::string& unit = {});

}  // namespace rhexis
