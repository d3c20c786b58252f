// SPDX-License-Identifier: GPL-3.0-or-later
// What an exercise has to say of a recording: marks on its time line, and why an item earned what it did.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rhexis::station {

enum class MarkKind { error, put_right, warning, note, step, injected };

struct StoryMark {
    MarkKind kind = MarkKind::note;
    double time_s = 0.0;
    std::string title;
    std::string text;  ///< what more there is to say; may be empty
};

struct StoryItem {
    std::string id;
    std::string name;
    double score = -1.0;  ///< below 0: not scored
    std::vector<std::string> reasons;
    std::vector<std::string> to_four;
};

struct Story {
    std::string title;
    std::vector<StoryMark> marks;  ///< by time
    std::vector<StoryItem> items;
    double total = 0.0;
    double max = 0.0;
    std::string fault;  ///< why there is none; empty: there is
};

/// result: of the exercise, as for report.json.
Story story_of(const nlohmann::json& result);

}  // namespace rhexis::station
