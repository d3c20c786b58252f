// SPDX-License-Identifier: GPL-3.0-or-later
// Where the page goes that says how good a calibration is.
#pragma once

#include <filesystem>
#include <string>

namespace rhexis::tracking {

/// calibration.html beside the rig's file, unless another file is given.
inline std::string page_beside(const std::string& rig, const std::string& given) {
    return given.empty() ? (std::filesystem::path(rig).parent_path() / "calibration.html").string() : given;
}

}  // namespace rhexis::tracking
