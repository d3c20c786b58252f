// SPDX-License-Identifier: GPL-3.0-or-later
// Pages that scripts make: scripts/report of a run, scripts/records of what is stored.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"

namespace rhexis {

/// Calls require("report").html(report, series, images) in a sandbox. root: folder that holds scripts/; images: file
/// name in the report to its bytes in base64. Returns the whole HTML text; errors name the script's file:line.
Result<std::string> report_html(const std::string& root, const nlohmann::json& report, const nlohmann::json& series,
                                const std::map<std::string, std::string>& images);

/// The same of another page: require(module).html(data).
Result<std::string> page_html(const std::string& root, const std::string& module, const nlohmann::json& data);

}  // namespace rhexis
