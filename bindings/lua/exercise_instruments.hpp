// SPDX-License-Identifier: GPL-3.0-or-later
// What an exercise, or an operation, is done with.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

/// Names of the instruments of an exercise's scene, or of the scenes of an operation's parts, each once, in their
/// order; also the microscope, where it is one. The error: as of loading it.
Result<std::vector<std::string>> instruments_of(const std::string& exercise, const std::string& root);

}  // namespace rhexis
