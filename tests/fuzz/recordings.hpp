// SPDX-License-Identifier: GPL-3.0-or-later
// Spoilt recordings: each is read as far as it goes or refused in one line; what can be read is simulated again.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "fuzz/batches.hpp"

namespace rhexis::fuzz {

/// Short recordings of some exercises by the random operator: their bytes.
Result<std::vector<std::string>> make_recordings(const std::string& root, const std::string& work);

struct RecordingsPlan {
    std::string work;
    std::uint64_t seed = 1;
    const std::vector<std::string>* recordings = nullptr;
};

Outcome recording_case(const RecordingsPlan& plan, std::uint64_t number);

}  // namespace rhexis::fuzz
