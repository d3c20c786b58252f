// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a session that a curriculum may set, with their ranges: the one list of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct SettingInfo {
    std::string_view name;
    std::string_view unit;
    double minimum = 0.0;
    double maximum = 1.0;
    double standard = 0.0;  ///< value when nobody sets it
    bool live = true;       ///< false: only in the scene's description, before the first step
    std::string_view meaning;
    bool tissue = false;  ///< of a live one: the eye's, not the machine's, which only an instructor's request changes
};

/// All settings, sorted by name.
std::span<const SettingInfo> setting_table();

/// Null when there is no such setting.
const SettingInfo* find_setting(std::string_view name);

/// Names near names for an unknown one, and the range for a value outside it.
Status check_setting(std::string_view name, double value);

}  // namespace rhexis
