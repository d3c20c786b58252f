// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study_result.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "cli/rank_test.hpp"
#include "cli/study_cohort.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;
using Items = std::map<std::string, double>;

/// One virtual surgeon over all exercises.
struct Surgeon {
    std::string group;
    std::uint64_t seed = 0;
    Items items;  ///< mean points
    double score = 0.0;
    double cpu_s = 0.0;
    int completed = 0;
    int attempts = 0;
    int errors = 0;
    int put_right = 0;
};

/// 20 to 100 for 1 to 5 points each.
double score_of(const Items& items) {
    double sum = 0.0;
    for (const auto& [id, points] : items) {
        sum += points;
    }
    return items.empty() ? 0.0 : 20.0 * sum / static_cast<double>(items.size());
}

double without(const Items& items, const std::string& id) {
    Items rest = items;
    rest.erase(id);
    return score_of(rest);
}

void add_items(const json& report, std::map<std::string, std::vector<double>>& points) {
    const json osacss = report.value("osacss", json());
    for (const json& item : osacss.is_object() ? osacss.value("items", json::array()) : json::array()) {
        if (item.contains("score") && item["score"].is_number()) {
            points[item.value("id", "")].push_back(item["score"].get<double>());
        }
    }
}

Surgeon surgeon_from(const std::vector<const StudyRun*>& runs) {
    Surgeon surgeon;
    std::map<std::string, std::vector<double>> points;
    for (const StudyRun* run : runs) {
        surgeon.group = run->group;
        surgeon.seed = run->seed;
        add_items(run->report, points);
        surgeon.attempts += 1;
        surgeon.completed += run->report.value("completed", false) ? 1 : 0;
        for (const json& event : run->report.value("events", json::array())) {
            const bool made = !event.value("given", false);
            surgeon.errors += made ? 1 : 0;
            surgeon.put_right += made && event.value("recovered", false) ? 1 : 0;
        }
        const json performance = run->report.value("performance", json::object());
        surgeon.cpu_s += performance.value("cpu_s_per_s", 0.0) * run->report.value("duration_s", 0.0);
    }
    for (const auto& [id, values] : points) {
        surgeon.items[id] = mean_of(values);
    }
    surgeon.score = score_of(surgeon.items);
    return surgeon;
}

std::vector<Surgeon> surgeons_of(const StudyPlan& plan, const std::vector<StudyRun>& runs) {
    std::vector<Surgeon> surgeons;
    for (const std::string& group : plan.groups) {
        for (std::uint64_t seed = plan.first_seed; seed <= plan.last_seed; ++seed) {
            std::vector<const StudyRun*> own;
            for (const StudyRun& run : runs) {
                if (run.group == group && run.seed == seed) {
                    own.push_back(&run);
                }
            }
            if (!own.empty()) {
                surgeons.push_back(surgeon_from(own));
            }
        }
    }
    return surgeons;
}

std::vector<double> scores_of(const std::vector<Surgeon>& surgeons, const std::string& group) {
    std::vector<double> scores;
    for (const Surgeon& surgeon : surgeons) {
        if (surgeon.group == group) {
            scores.push_back(surgeon.score);
        }
    }
    return scores;
}

std::vector<double> points_of(const std::vector<Surgeon>& surgeons, const std::string& group, const std::string& item) {
    std::vector<double> points;
    for (const Surgeon& surgeon : surgeons) {
        if (surgeon.group == group && surgeon.items.contains(item)) {
            points.push_back(surgeon.items.at(item));
        }
    }
    return points;
}

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json group_line(const StudyPlan& plan, const std::vector<Surgeon>& surgeons, const std::string& group) {
    const std::vector<double> scores = scores_of(surgeons, group);
    json line = {{"group", group}, {"n", scores.size()}, {"mean", mean_of(scores)}, {"sd", deviation_of(scores)}};
    if (!scores.empty()) {
        line["least"] = *std::min_element(scores.begin(), scores.end());
        line["most"] = *std::max_element(scores.begin(), scores.end());
    }
    for (const char* key : {"attempts", "completed", "errors", "put_right"}) {
        line[key] = 0;
    }
    for (const Surgeon& surgeon : surgeons) {
        if (surgeon.group == group) {
            line["attempts"] = line["attempts"].get<int>() + surgeon.attempts;
            line["completed"] = line["completed"].get<int>() + surgeon.completed;
            line["errors"] = line["errors"].get<int>() + surgeon.errors;
            line["put_right"] = line["put_right"].get<int>() + surgeon.put_right;
        }
    }
    if (plan.published.is_object()) {
        line["published"] = plan.published.value("groups", json::object()).value(group, json());
    }
    return line;
}

json test_line(const std::vector<Surgeon>& surgeons, const std::string& first, const std::string& second) {
    const RankTest test = mann_whitney(scores_of(surgeons, first), scores_of(surgeons, second));
    return {{"groups", {first, second}}, {"u", test.u}, {"p", test.p}, {"exact", test.exact}};
}

json item_line(const StudyPlan& plan, const std::vector<Surgeon>& surgeons, const std::string& item) {
    json line = {{"id", item}, {"groups", json::object()}};
    std::vector<double> own;
    std::vector<double> rest;
    for (const Surgeon& surgeon : surgeons) {
        if (surgeon.items.contains(item)) {
            own.push_back(surgeon.items.at(item));
            rest.push_back(without(surgeon.items, item));
        }
    }
    for (const std::string& group : plan.groups) {
        const std::vector<double> points = points_of(surgeons, group, item);
        line["groups"][group] = {{"n", points.size()}, {"mean", mean_of(points)}, {"sd", deviation_of(points)}};
    }
    line["p"] =
        mann_whitney(points_of(surgeons, plan.groups.front(), item), points_of(surgeons, plan.groups.back(), item)).p;
    line["correlation_with_rest"] = number_or_null(correlation_of(own, rest));
    return line;
}

std::string format(const char* form, double value) {
    char text[48];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

std::string spread(const char* form, double mean, double sd) {
    std::string text = format(form, mean);
    return text.append(" ± ").append(format(form, sd));
}

std::string probability(double p) { return p < 0.001 ? "< 0.001" : format("%.3f", p); }

std::string table_row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) {
        text.append(" ").append(cell).append(" |");
    }
    return text.append("\n");
}

std::string table_head(const std::vector<std::string>& cells) {
    std::string text = table_row(cells).append("|");
    for (std::size_t i = 0; i < cells.size(); ++i) {
        text.append("---|");
    }
    return text.append("\n");
}

std::string published_text(const json& group) {
    const json published = group.value("published", json());
    if (!published.is_object()) {
        return "-";
    }
    return spread("%.1f", published.at("mean"), published.at("sd")).append(" (").append(published.at("n").dump()) + ")";
}

std::string range_text(const json& group) {
    return group.contains("least") ? format("%.1f", group.at("least")).append(" to ") + format("%.1f", group.at("most"))
                                   : "-";
}

std::string groups_table(const json& result) {
    std::string text = table_head({"group", "surgeons", "score, mean ± SD", "range", "published, mean ± SD (n)",
                                   "attempts completed", "errors (put right)"});
    for (const json& group : result.at("groups")) {
        text += table_row({group.at("group"), group.at("n").dump(), spread("%.1f", group.at("mean"), group.at("sd")),
                           range_text(group), published_text(group),
                           group.at("completed").dump().append(" of ") + group.at("attempts").dump(),
                           group.at("errors").dump().append(" (").append(group.at("put_right").dump()) + ")"});
    }
    return text;
}

std::string tests_table(const json& result) {
    std::string text = table_head({"groups", "U", "p, two-sided", ""});
    for (const json& test : result.at("tests")) {
        const auto first = test.at("groups")[0].get<std::string>();
        text += table_row({std::string(first).append(" and ") + test.at("groups")[1].get<std::string>(),
                           format("%g", test.at("u")), probability(test.at("p")),
                           test.at("exact") == true ? "exact" : "normal, ties corrected"});
    }
    return text;
}

std::string exercises_table(const json& result) {
    std::vector<std::string> head{"exercise"};
    for (const json& group : result.at("groups")) {
        head.push_back(group.at("group").get<std::string>().append(": completed; their share of the scale"));
    }
    std::string text = table_head(head);
    for (const auto& [exercise, groups] : result.at("exercises").items()) {
        std::vector<std::string> cells{exercise};
        for (const json& group : result.at("groups")) {
            const json& own = groups.at(group.at("group").get<std::string>());
            std::string cell = own.at("completed").dump().append(" of ") + own.at("attempts").dump();
            cells.push_back(
                own.at("completed") == 0 ? cell : cell.append("; ") + spread("%.2f", own.at("mean"), own.at("sd")));
        }
        text += table_row(cells);
    }
    return text;
}

std::string items_table(const json& result) {
    std::vector<std::string> head{"item"};
    for (const json& group : result.at("groups")) {
        head.push_back(group.at("group"));
    }
    head.insert(head.end(), {"p, first and last", "correlation with the rest"});
    std::string text = table_head(head);
    for (const json& item : result.at("items")) {
        std::vector<std::string> cells{item.at("id")};
        for (const json& group : result.at("groups")) {
            const json& own = item.at("groups").at(group.at("group").get<std::string>());
            cells.push_back(own.at("n") == 0 ? "-" : spread("%.2f", own.at("mean"), own.at("sd")));
        }
        const json& correlation = item.at("correlation_with_rest");
        cells.push_back(probability(item.at("p")));
        cells.push_back(correlation.is_null() ? "-" : format("%.2f", correlation));
        text += table_row(cells);
    }
    return text;
}

}  // namespace

json study_result(const StudyPlan& plan, const std::vector<StudyRun>& runs) {
    const std::vector<Surgeon> surgeons = surgeons_of(plan, runs);
    json result = {{"study", plan.name},     {"title", plan.title},    {"groups", json::array()},
                   {"tests", json::array()}, {"items", json::array()}, {"surgeons", json::array()}};
    std::set<std::string> items;
    double cpu_s = 0.0;
    for (const Surgeon& surgeon : surgeons) {
        result["surgeons"].push_back(
            {{"group", surgeon.group}, {"seed", surgeon.seed}, {"score", surgeon.score}, {"items", surgeon.items}});
        cpu_s += surgeon.cpu_s;
        for (const auto& [id, points] : surgeon.items) {
            items.insert(id);
        }
    }
    for (const std::string& group : plan.groups) {
        result["groups"].push_back(group_line(plan, surgeons, group));
    }
    for (std::size_t i = 0; i + 1 < plan.groups.size(); ++i) {
        result["tests"].push_back(test_line(surgeons, plan.groups[i], plan.groups[i + 1]));
    }
    if (plan.groups.size() > 2) {
        result["tests"].push_back(test_line(surgeons, plan.groups.front(), plan.groups.back()));
    }
    for (const std::string& item : items) {
        result["items"].push_back(item_line(plan, surgeons, item));
    }
    result["exercises"] = json::object();
    for (const auto& [exercise, groups] : scores_by_exercise(plan, runs)) {
        for (const GroupScores& group : groups) {
            result["exercises"][exercise][group.group] = {{"attempts", group.attempts},
                                                          {"completed", group.completed.size()},
                                                          {"mean", mean_of(group.completed)},
                                                          {"sd", deviation_of(group.completed)}};
        }
    }
    result["published_source"] = plan.published.is_object() ? plan.published.value("source", json()) : json();
    result["attempts"] = runs.size();
    result["cpu_s"] = cpu_s;
    return result;
}

std::string study_text(const json& result) {
    std::string text = "# ";
    text.append(result.at("title").get<std::string>()).append("\n\n").append(groups_table(result)).append("\n");
    if (result.at("published_source").is_string()) {
        text.append("Published: ").append(result.at("published_source").get<std::string>()).append(".\n\n");
    }
    text.append(tests_table(result)).append("\n").append(items_table(result)).append("\n");
    text.append(exercises_table(result)).append("\n");
    text.append(result.at("attempts").dump()).append(" attempts, ").append(format("%.0f", result.at("cpu_s")));
    return text.append(" s of CPU in the kernel. Not validated clinically.\n");
}

}  // namespace rhexis::cli
