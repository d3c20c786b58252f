// SPDX-License-Identifier: GPL-3.0-or-later
// "1 attempt", "2 attempts".
#pragma once

#include <cstddef>
#include <string>

namespace rhexis::cli {

inline std::string counted(std::size_t n, const std::string& thing) {
    return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace rhexis::cli
