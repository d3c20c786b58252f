// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/coverage.hpp"

#include <array>

namespace rhexis::cli {
namespace {

struct Aspect {
    const char* key;
    const char* missing;
};

constexpr std::array<Aspect, 4> aspects{{{"raised", "never raised"},
                                         {"recovered", "never raised and recovered"},
                                         {"not_recovered", "never raised and not recovered"},
                                         {"silent", "without a silent twin"}}};

}  // namespace

bool Coverage::lacks(const Event& event, std::string_view key) {
    return !event.seen.contains(std::string(key)) && (event.recovers || key != "recovered");
}

void Coverage::add(const std::string& exercise, const ScenarioResult& result) {
    if (!result.declared.is_array()) {
        return;
    }
    std::map<std::string, Event>& events = exercises_[exercise];
    for (const nlohmann::json& declared : result.declared) {
        events[declared.at("id")].title = declared.at("title");
        events[declared.at("id")].recovers = declared.value("recovers", true);
    }
    if (!result.passed()) {
        return;
    }
    for (const auto& [id, outcomes] : result.covered.items()) {
        for (const auto& [outcome, yes] : outcomes.items()) {
            events[id].seen[outcome] = true;
        }
    }
}

std::vector<std::string> Coverage::lines() const {
    std::vector<std::string> lines;
    for (const auto& [exercise, events] : exercises_) {
        std::vector<std::string> gaps;
        for (const Aspect& aspect : aspects) {
            std::string titles;
            for (const auto& [id, event] : events) {
                // what was never raised is not said three times
                const bool named =
                    aspect.key == aspects[0].key || !lacks(event, "raised") || aspect.key == aspects[3].key;
                if (named && lacks(event, aspect.key)) {
                    titles += (titles.empty() ? "" : ", ") + event.title;
                }
            }
            if (!titles.empty()) {
                gaps.push_back(std::string("  ").append(aspect.missing).append(": ").append(titles));
            }
        }
        lines.push_back(exercise + ": " + std::to_string(events.size()) +
                        (gaps.empty() ? " error events, each raised, recovered, not recovered, with a silent twin"
                                      : " error events"));
        lines.insert(lines.end(), gaps.begin(), gaps.end());
    }
    return lines;
}

bool Coverage::complete() const {
    for (const auto& [exercise, events] : exercises_) {
        for (const auto& [id, event] : events) {
            for (const Aspect& aspect : aspects) {
                if (lacks(event, aspect.key)) {
                    return false;
                }
            }
        }
    }
    return true;
}

}  // namespace rhexis::cli
