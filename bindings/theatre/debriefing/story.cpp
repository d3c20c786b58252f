// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/debriefing/story.hpp"

#include <algorithm>
#include <utility>

namespace rhexis::station {
namespace {

using nlohmann::json;

const json& list_in(const json& object, const char* name) {
    static const json none = json::array();
    const auto found = object.find(name);
    return found != object.end() && found->is_array() ? *found : none;
}

std::vector<std::string> texts_in(const json& list) {
    std::vector<std::string> texts;
    for (const json& one : list) {
        texts.push_back(one.is_string() ? one.get<std::string>() : one.value("text", ""));
    }
    return texts;
}

void add_events(const json& result, std::vector<StoryMark>& marks) {
    for (const json& event : list_in(result, "events")) {
        const double time_s = event.value("time_s", 0.0);
        marks.push_back({MarkKind::error, time_s, event.value("title", ""), event.value("advice", "")});
        if (event.contains("recovery_s")) {
            marks.push_back(
                {MarkKind::put_right, time_s + event["recovery_s"].get<double>(), event.value("title", ""), ""});
        }
    }
}

StoryItem item_of(const json& item) {
    StoryItem told{item.value("id", ""),
                   item.value("name", ""),
                   item.value("score", -1.0),
                   texts_in(list_in(item, "reasons")),
                   {}};
    const json way = item.value("to_four", json::object());
    for (const char* part : {"errors", "measures"}) {
        const std::vector<std::string> texts = texts_in(list_in(way, part));
        told.to_four.insert(told.to_four.end(), texts.begin(), texts.end());
    }
    return told;
}

}  // namespace

Story story_of(const json& result) {
    Story story;
    story.title = result.value("title", "");
    add_events(result, story.marks);
    for (const json& one : list_in(result, "warnings")) {
        story.marks.push_back(
            {MarkKind::warning, one.value("time_s", 0.0), one.value("title", ""), one.value("advice", "")});
    }
    for (const json& one : list_in(result, "notes")) {
        story.marks.push_back({MarkKind::note, one.value("time_s", 0.0), one.value("text", ""), ""});
    }
    for (const json& aid : list_in(result, "aids")) {
        if (aid.value("id", "") == "injected") {
            for (const json& one : list_in(aid, "told")) {
                story.marks.push_back({MarkKind::injected, one.value("time_s", 0.0), one.value("text", ""), ""});
            }
        }
    }
    for (const json& step : list_in(result, "steps")) {
        if (step.contains("start_s")) {
            story.marks.push_back({MarkKind::step, step["start_s"].get<double>(), step.value("title", ""), ""});
        }
    }
    std::stable_sort(story.marks.begin(), story.marks.end(),
                     [](const StoryMark& a, const StoryMark& b) { return a.time_s < b.time_s; });
    const json score = result.value("osacss", json());
    if (score.is_object()) {
        story.total = score.value("total", 0.0);
        story.max = score.value("max", 0.0);
        for (const json& item : list_in(score, "items")) {
            story.items.push_back(item_of(item));
        }
    }
    return story;
}

}  // namespace rhexis::station
