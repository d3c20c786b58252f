// SPDX-License-Identifier: GPL-3.0-or-later
// What two scenes do not have in common, as one line.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "session/settings.hpp"

namespace rhexis {

class SceneDifferences {
public:
    void add(const std::string& name, const std::string& there, const std::string& here);
    void add(const std::string& name, double there, double here);
    void add(const std::string& name, const std::vector<std::string>& there, const std::vector<std::string>& here);
    /// Of settings that are fixed before the first step, those that count.
    void add_settings(const std::map<std::string, double>& there, const std::map<std::string, double>& here,
                      const std::function<bool(const SettingInfo&)>& counts);

    /// Empty when there is none.
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace rhexis
