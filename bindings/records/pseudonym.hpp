// SPDX-License-Identifier: GPL-3.0-or-later
// The names under which trainees, cohorts, arms and raters are stored.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis::records {

/// Fails for what is no plain short word of letters, digits, '-', '_' and '.', and for what looks like an e-mail
/// address. option: for messages, "--trainee".
Status check_pseudonym(const std::string& name, const std::string& option);

}  // namespace rhexis::records
