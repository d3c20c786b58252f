// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.hpp"
#include "records/gates.hpp"

namespace rhexis::cli {

/// file: "" stands for root/rubrics/gates.json.
Result<records::Gates> read_gates(const std::string& file, const std::string& root);

}  // namespace rhexis::cli
