// SPDX-License-Identifier: GPL-3.0-or-later
// What a report compares an attempt with (docs/report.md: "history" and "cohort").
#pragma once

#include <nlohmann/json.hpp>

#include "base/result.hpp"
#include "records/gates.hpp"
#include "records/store.hpp"

namespace rhexis::records {

/// Name of the cohort that stands in where the trainee's own has nobody else.
inline constexpr const char* reference_cohort = "reference";

/// "history": scored attempts of the trainee at the same exercise, oldest first. "cohort": the last scored attempt of
/// each of the others in the trainee's cohort, or else in the cohort "reference", if there are at least two. Either is
/// missing where there is none.
Result<nlohmann::json> comparison_for(Store& store, const Attempt& attempt, const Gates& gates);

}  // namespace rhexis::records
