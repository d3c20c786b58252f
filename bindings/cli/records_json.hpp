// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "records/attempt.hpp"

namespace rhexis::cli {

const char* state_name(records::AttemptState state);

/// All that is stored of an attempt; its details where they were read.
nlohmann::json attempt_json(const records::Attempt& attempt);

}  // namespace rhexis::cli
