// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis::records {

/// Fails on a key of the object that is none of `known`, with the near ones.
Status check_keys(const nlohmann::json& given, const std::vector<std::string>& known, const std::string& where);

}  // namespace rhexis::records
