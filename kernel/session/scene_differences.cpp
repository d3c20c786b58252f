// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_differences.hpp"

#include "base/numbers.hpp"

namespace rhexis {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        list += (list.empty() ? "" : " + ") + name;
    }
    return list.empty() ? "none" : list;
}

}  // namespace

void SceneDifferences::add(const std::string& name, const std::string& there, const std::string& here) {
    if (there != here) {
        text_ += (text_.empty() ? "" : "; ") + name + " " + there + " there, " + here + " here";
    }
}

void SceneDifferences::add(const std::string& name, double there, double here) {
    if (there != here) {
        add(name, short_number(there), short_number(here));
    }
}

void SceneDifferences::add(const std::string& name, const std::vector<std::string>& there,
                           const std::vector<std::string>& here) {
    add(name, joined(there), joined(here));
}

void SceneDifferences::add_settings(const std::map<std::string, double>& there,
                                    const std::map<std::string, double>& here,
                                    const std::function<bool(const SettingInfo&)>& counts) {
    for (const SettingInfo& info : setting_table()) {
        const auto then = there.find(std::string(info.name));
        const auto now = here.find(std::string(info.name));
        if (!info.live && counts(info) && then != there.end() && now != here.end()) {
            add(then->first, then->second, now->second);
        }
    }
}

}  // namespace rhexis
