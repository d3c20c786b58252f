// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/settings.hpp"

#include <algorithm>
#include <array>

#include "base/near_names.hpp"
#include "base/numbers.hpp"

namespace rhexis {
namespace {

constexpr std::array<SettingInfo, 3> table{{
    {"capsulorhexis.diameter_mm", "mm", 3.0, 8.0, 5.25, false, "Diameter of the opening in the anterior capsule."},
    {"phaco.power_limit", "1", 0.0, 1.0, 1.0, true,
     "Ultrasound power at full pedal, share of the machine's full power."},
    {"zonules.strength", "1", 0.05, 2.0, 1.0, false, "Stiffness of the zonules, share of that at the patient's age."},
}};

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const SettingInfo& info : table) {
        list.emplace_back(info.name);
    }
    return list;
}

}  // namespace

std::span<const SettingInfo> setting_table() { return table; }

const SettingInfo* find_setting(std::string_view name) {
    const auto* found =
        std::find_if(table.begin(), table.end(), [&](const SettingInfo& info) { return info.name == name; });
    return found == table.end() ? nullptr : found;
}

Status check_setting(std::string_view name, double value) {
    const SettingInfo* info = find_setting(name);
    if (info == nullptr) {
        return Error{"there is no setting " + std::string(name), "settings", suggestion(name, names())};
    }
    return check_range("settings." + std::string(name), value, info->minimum, info->maximum);
}

}  // namespace rhexis
