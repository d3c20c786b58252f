// SPDX-License-Identifier: GPL-3.0-or-later
// Simulator against raters, and raters among themselves: per item and for the total.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "records/attempt.hpp"

namespace rhexis::records {

/// {"raters": [...], "attempts": n, "rows": [{"item", "name", "raters": {...}, "simulator": {...}}]}: the last row is
/// the total, mean points per item x 20, over the items that the simulator and every rater scored. "raters" of a row
/// has "icc" (or "why" not) and the raters' "pairs"; "simulator" has "icc" and "limits" against the mean of the raters
/// and "points", [mean of the two, simulator - raters] of each attempt. attempts: with items; those without a rating
/// do not count. What one rater left out is left out for all.
nlohmann::json compare_judges(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings);

}  // namespace rhexis::records
