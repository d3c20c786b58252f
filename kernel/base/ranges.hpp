// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a model, each with the range in which it must lie.
#pragma once

#include <initializer_list>
#include <string>

#include "base/result.hpp"

namespace rhexis {

struct RangedNumber {
    const char* name;
    double value;
    double least;
    double most;
    const char* unit = "";  ///< with the blank before it, or empty
};

/// Fails on the first outside its range, or that is not a number: "where: name is 12 (3 to 9 mm)".
Status check_ranges(std::initializer_list<RangedNumber> numbers, const std::string& where);

}  // namespace rhexis
