// SPDX-License-Identifier: GPL-3.0-or-later
// The files of assets/tracking/bodies, which the build puts into the program.
#pragma once

#include <string_view>

namespace rhexis {

/// Text of assets/tracking/bodies/<file>; empty: there is no such file.
std::string_view marker_body_text(std::string_view file);

}  // namespace rhexis
