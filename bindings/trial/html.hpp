// SPDX-License-Identifier: GPL-3.0-or-later
// report.html of a run's folder, made from report.json, series.json and frames/ by scripts/report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"

namespace rhexis {

/// Fails when a file of the folder is missing or broken, or the script errs. instead: fields that take the place of
/// those of report.json.
Result<std::string> report_page(const std::string& root, const std::string& folder,
                                const nlohmann::json& instead = nlohmann::json::object());

}  // namespace rhexis
