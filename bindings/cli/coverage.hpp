// SPDX-License-Identifier: GPL-3.0-or-later
// Which error events the scenario tests of each exercise raise, and how they end.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "trial/scenario_run.hpp"

namespace rhexis::cli {

class Coverage {
public:
    /// Scenarios that did not pass count for nothing.
    void add(const std::string& exercise, const ScenarioResult& result);

    /// One line per exercise, or several where something is missing.
    [[nodiscard]] std::vector<std::string> lines() const;
    /// Every error event was raised, put right (if it can be), not put right, and has a silent twin.
    [[nodiscard]] bool complete() const;

private:
    struct Event {
        std::string title;
        bool recovers = true;  ///< false: the exercise does not say how it is put right
        std::map<std::string, bool> seen;
    };
    static bool lacks(const Event& event, std::string_view key);

    std::map<std::string, std::map<std::string, Event>> exercises_;
};

}  // namespace rhexis::cli
