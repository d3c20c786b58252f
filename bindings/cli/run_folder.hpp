// SPDX-License-Identifier: GPL-3.0-or-later
// What a run's folder holds of a trainee's attempt: attempt.json says whose it is, the rest of the folder how it went.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"
#include "records/attempt.hpp"

namespace rhexis::cli {

inline constexpr const char* note_file = "attempt.json";

/// added: the run was made without a trainee, and is given one later; its report does not name the attempt.
Status write_note(const std::string& folder, const records::Attempt& attempt, bool added);
Result<records::Attempt> read_note(const std::string& folder);

/// Fills in the end of an attempt whose recordings lie in its folder.
Status complete(records::Attempt& attempt, const nlohmann::json& report);

/// The same from the files of its folder; fails where the run did not come to its report, and where the report is one
/// that an earlier run left there.
Status complete_from_folder(records::Attempt& attempt);

/// Deletes what rhexis wrote into the folder of this attempt, and the folder if that was all. Does nothing where the
/// folder holds another attempt by now. Returns whether it did.
bool delete_run(const std::string& folder, const std::string& trainee);

}  // namespace rhexis::cli
