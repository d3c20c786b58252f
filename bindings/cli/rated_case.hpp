// SPDX-License-Identifier: GPL-3.0-or-later
// What a rater is told of a recording: which exercise it is of, and which items that judges. Nothing of whose it is.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rhexis::cli {

/// "title", in the language of the page, and "items", ids of OSACSS; each where the folder of the run tells of it.
/// run: as it was named, the folder or a recording in it.
nlohmann::json case_of_run(const std::string& run, const std::string& language, const std::string& root);

}  // namespace rhexis::cli
