// SPDX-License-Identifier: GPL-3.0-or-later
// Spoils texts and bytes, the same way for the same random stream.
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace rhexis::fuzz {

using Random = std::mt19937_64;

/// 0 to below - 1; below at least 1.
std::size_t pick(Random& random, std::size_t below);

/// Names, numbers, texts in quotes, signs and the space between: joined they are the text again.
std::vector<std::string> tokens_of(std::string_view text);

/// One to three changes of tokens: removed, doubled, exchanged, taken from elsewhere, a number or text made another
/// one. Most put like in the place of like.
std::string mutate_tokens(const std::string& text, Random& random);

/// One to five changes that most often leave a text that loads: numbers made larger or smaller, comparisons and joining
/// words exchanged, one measure put in the place of another.
std::string mutate_meaning(const std::string& text, Random& random);

/// One to four changes of bytes: flipped, overwritten, put in, taken out, doubled, or all behind one cut off.
std::string mutate_bytes(const std::string& bytes, Random& random);

}  // namespace rhexis::fuzz
