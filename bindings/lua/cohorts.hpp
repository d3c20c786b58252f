// SPDX-License-Identifier: GPL-3.0-or-later
// How groups of virtual surgeons did each exercise: rubrics/cohorts.json, made by `rhexis study cohort`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"
#include "lua/curriculum_files.hpp"

namespace rhexis {

/// The entry of an exercise: "decides" (hash of what decided how it went), "rubric", "items", "seeds", "groups",
/// "cuts". Null where there is none. With "stale" where the exercise is another one than it was then. Fails where the
/// file cannot be read as what it is to be.
Result<nlohmann::json> reference_cohort(const CurriculumFiles& files, const std::string& root);

}  // namespace rhexis
