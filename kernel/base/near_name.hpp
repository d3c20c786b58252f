// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestions for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rhexis {

/// Names within a small edit distance of `name` (at most a third of its length, at least 1), nearest first, at most 3.
std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& names);

/// " (did you mean 'friction'?)", or empty when nothing is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& names);

}  // namespace rhexis
