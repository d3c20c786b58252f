// SPDX-License-Identifier: GPL-3.0-or-later
// What the store takes from report.json (docs/report.md), and what it gives to it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"
#include "records/attempt.hpp"

namespace rhexis::records {

/// Fills in what is known once an attempt is finished; fails on what is no report of schema 1.
Status take_report(const nlohmann::json& report, Attempt& attempt);

/// attempt.json, which a run's folder holds while and after an attempt of a trainee.
nlohmann::json note_of(const Attempt& attempt);
Result<Attempt> attempt_from_note(const nlohmann::json& note, const std::string& where);

}  // namespace rhexis::records
