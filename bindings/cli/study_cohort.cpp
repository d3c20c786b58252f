// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study_cohort.hpp"

#include <algorithm>
#include <cmath>

#include "cli/rank_test.hpp"
#include "lua/curriculum_files.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;
using Groups = std::vector<GroupScores>;

constexpr std::size_t fewest_completed = 3;
constexpr double told_apart = 0.05;  // p of the rank test

std::vector<double> together(const Groups& groups, std::size_t first, std::size_t last) {
    std::vector<double> all;
    for (std::size_t i = first; i < last; ++i) {
        all.insert(all.end(), groups[i].completed.begin(), groups[i].completed.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The share of the scale that leaves most of `low` below and of `high` above it: the middle of the widest such gap.
double cut_between(const std::vector<double>& low, const std::vector<double>& high) {
    std::vector<double> places = low;
    places.insert(places.end(), high.begin(), high.end());
    std::sort(places.begin(), places.end());
    const auto share_right = [&](double cut) {
        const auto below = std::lower_bound(low.begin(), low.end(), cut) - low.begin();
        const auto above = high.end() - std::lower_bound(high.begin(), high.end(), cut);
        return static_cast<double>(below) / static_cast<double>(low.size()) +
               static_cast<double>(above) / static_cast<double>(high.size());
    };
    double best = places.front();
    double most = -1.0;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double middle = 0.5 * (places[i] + places[i + 1]);
        const double gap = places[i + 1] - places[i];
        const double right = share_right(middle);
        if (right > most + 1e-12 || (right > most - 1e-12 && gap > widest)) {
            best = middle;
            most = right;
            widest = gap;
        }
    }
    return std::round(best * 1e4) / 1e4;
}

/// Parts the groups [first, last) as long as both sides are told apart; from: least share that is like the first.
void part(const Groups& groups, std::size_t first, std::size_t last, double from, json& cuts) {
    std::size_t where = first;
    double least = told_apart;
    for (std::size_t at = first + 1; at < last; ++at) {
        const std::vector<double> low = together(groups, first, at);
        const std::vector<double> high = together(groups, at, last);
        const double p = mann_whitney(low, high).p;
        if (p < least && mean_of(low) < mean_of(high)) {
            least = p;
            where = at;
        }
    }
    if (where == first) {
        json names = json::array();
        for (std::size_t i = first; i < last; ++i) {
            names.push_back(groups[i].group);
        }
        cuts.push_back({{"from", from}, {"groups", names}, {"n", together(groups, first, last).size()}});
        return;
    }
    const double cut = std::max(from, cut_between(together(groups, first, where), together(groups, where, last)));
    part(groups, first, where, from, cuts);
    part(groups, where, last, cut, cuts);
}

std::string exercise_of(const StudyRun& run) { return run.report.value("/curriculum/id"_json_pointer, std::string()); }

json items_scored(const json& report) {
    json ids = json::array();
    for (const json& item : report.value("/osacss/items"_json_pointer, json::array())) {
        if (item.contains("score") && item["score"].is_number()) {
            ids.push_back(item.value("id", ""));
        }
    }
    return ids;
}

/// The items that most completed attempts were scored on.
json usual_items(const std::vector<StudyRun>& runs, const std::string& exercise) {
    std::map<std::string, std::pair<int, json>> seen;
    json usual = json::array();
    int most = 0;
    for (const StudyRun& run : runs) {
        if (exercise_of(run) == exercise && run.report.value("completed", false)) {
            auto& [count, items] = seen[items_scored(run.report).dump()];
            items = items_scored(run.report);
            if (++count > most) {
                most = count;
                usual = items;
            }
        }
    }
    return usual;
}

}  // namespace

std::map<std::string, Groups> scores_by_exercise(const StudyPlan& plan, const std::vector<StudyRun>& runs) {
    std::map<std::string, Groups> all;
    for (const StudyRun& run : runs) {
        Groups& groups = all[exercise_of(run)];
        if (groups.empty()) {
            for (const std::string& group : plan.groups) {
                groups.push_back({group, 0, {}});
            }
        }
        const auto own =
            std::find_if(groups.begin(), groups.end(), [&](const GroupScores& one) { return one.group == run.group; });
        ++own->attempts;
        const json scaled = run.report.value("/osacss/scaled"_json_pointer, json());
        if (run.report.value("completed", false) && scaled.is_number()) {
            own->completed.push_back(scaled.get<double>());
        }
    }
    for (auto& [exercise, groups] : all) {
        for (GroupScores& group : groups) {
            std::sort(group.completed.begin(), group.completed.end());
        }
    }
    return all;
}

json cuts_of(const Groups& groups) {
    Groups enough;
    std::copy_if(groups.begin(), groups.end(), std::back_inserter(enough),
                 [](const GroupScores& group) { return group.completed.size() >= fewest_completed; });
    json cuts = json::array();
    if (!enough.empty()) {
        part(enough, 0, enough.size(), 0.0, cuts);
    }
    return cuts;
}

json cohorts_of(const StudyPlan& plan, const std::vector<StudyRun>& runs, const std::string& root) {
    json all = {{"note",
                 "How virtual surgeons did each exercise, and where the scores of their groups part; made by "
                 "`rhexis study " +
                     plan.name + "`, which says in docs/records.md how. They are models, not people."},
                {"exercises", json::object()}};
    for (const auto& [exercise, groups] : scores_by_exercise(plan, runs)) {
        json entry = {{"decides", hash_of_what_decides(exercise, root)},
                      {"rubric", "OSACSS"},
                      {"items", usual_items(runs, exercise)},
                      {"seeds", {plan.first_seed, plan.last_seed}},
                      {"groups", json::object()},
                      {"cuts", cuts_of(groups)}};
        for (const GroupScores& group : groups) {
            entry["groups"][group.group] = {{"attempts", group.attempts}, {"completed", group.completed}};
        }
        all["exercises"][exercise] = entry;
    }
    return all;
}

}  // namespace rhexis::cli
