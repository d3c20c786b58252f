// SPDX-License-Identifier: GPL-3.0-or-later
// The files of assets/instruments, which the build puts into the program.
#pragma once

#include <string_view>

namespace rhexis {

/// Text of assets/instruments/<file>; empty: there is no such file.
std::string_view instrument_text(std::string_view file);

}  // namespace rhexis
