// SPDX-License-Identifier: GPL-3.0-or-later
// report.html of a run's folder, made from report.json, series.json and frames/ by scripts/report.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis::cli {

/// Fails when a file of the folder is missing or broken, or the script errs.
Result<std::string> report_page(const std::string& root, const std::string& folder);

}  // namespace rhexis::cli
