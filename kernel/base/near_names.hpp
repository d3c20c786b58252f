// SPDX-License-Identifier: GPL-3.0-or-later
// Names that someone may have meant when they typed one that does not exist.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rhexis {

/// Edits (insert, delete, replace, swap neighbours) that turn one word into the other.
int edit_distance(std::string_view a, std::string_view b);

/// At most `count` of the candidates, nearest first; none that is farther than a third of the word.
std::vector<std::string> near_names(std::string_view word, std::span<const std::string> candidates, int count = 3);

/// For the `allowed` of an Error: "did you mean a or b?", or "one of a, b, c" when none is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// To append to a message: " (did you mean 'a' or 'b'?)", or nothing when none is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace rhexis
