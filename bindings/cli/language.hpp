// SPDX-License-Identifier: GPL-3.0-or-later
// The language of what people read: as asked for, or as the environment says.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis::cli {

/// Of --language, in the help of a command.
constexpr const char* language_help = "Of all texts: en, fr, ... [as LANG says, where there are texts]";

/// The language that the environment asks for, where the shared scripts have texts in it; empty: English.
std::string language_of_environment(const std::string& root);

/// Of a page that is of no exercise: `given`, or as the environment says. Fails where the scripts have no texts in it.
Result<std::string> language_of_page(const std::string& given, const std::string& root);

}  // namespace rhexis::cli
