// SPDX-License-Identifier: GPL-3.0-or-later
// What a rater's form saves.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "records/attempt.hpp"

namespace rhexis::cli {

/// T1 to T14, G1 to G6.
const std::vector<std::string>& rated_item_names();

struct Answers {
    std::string code;  ///< of the recording
    records::Rating rating;
};

/// Fails on what is no such file, and on items that are missing, unknown or not of 1 to 5 points.
Result<Answers> read_answers(const std::string& path);

/// The name under which a recording goes in forms: from its bytes, so that it tells nothing of where it comes from.
std::string code_of(const std::string& sha256);

}  // namespace rhexis::cli
