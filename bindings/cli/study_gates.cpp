// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study_gates.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "cli/gates_file.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/operation_script.hpp"
#include "records/report_fields.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;

constexpr const char* kept_file = "/rubrics/gates_accepted.json";
constexpr double experts_pass = 0.8;
constexpr double beginners_pass = 0.4;

Status count(const StudyRun& run, const records::Gates& gates, const std::string& root, json& exercises) {
    records::Attempt attempt;
    if (Status taken = records::take_report(run.report, attempt); !taken) {
        return taken;
    }
    const records::Gate& gate = gates.of(attempt.exercise);
    json& entry = exercises[attempt.exercise];
    if (entry.is_null()) {
        entry = {{"decides", hash_of_what_decides(attempt.exercise, root)},
                 {"pass", gate.pass},
                 {"tells_apart", gate.tells_apart},
                 {"groups", json::object()}};
    }
    json& group = entry["groups"][run.group];
    if (group.is_null()) {
        group = {{"passed", 0}, {"of", 0}};
    }
    group["of"] = group["of"].get<int>() + 1;
    group["passed"] = group["passed"].get<int>() + (records::passes(attempt, gate) ? 1 : 0);
    return success();
}

double share_passed(const json& entry, const char* group) {
    const json found = entry.value("groups", json::object()).value(group, json());
    return found.is_object() ? found.at("passed").get<double>() / std::max(1.0, found.at("of").get<double>()) : -1.0;
}

bool comes_up(const json& entry) {
    return share_passed(entry, "d") >= experts_pass && share_passed(entry, "a") <= beginners_pass;
}

/// The exercises that there are, operations left out.
std::vector<std::string> exercises_in(const std::string& root) {
    std::vector<std::string> names = curricula_in(root);
    std::erase_if(names, [&root](const std::string& name) {
        const Result<std::optional<Operation>> operation = load_operation(name, root);
        return operation && operation.value();
    });
    return names;
}

/// Attempts of the group that was tried least.
int times_tried(const StudyPlan& plan, const json& entry) {
    int least = std::numeric_limits<int>::max();
    for (const std::string& group : plan.groups) {
        least = std::min(least, entry.at("groups").value(group, json::object()).value("of", 0));
    }
    return least;
}

std::string difference(const StudyPlan& plan, const std::string& exercise, const json& entry, const records::Gate& gate,
                       const std::string& root) {
    if (!entry.is_object() || !entry.contains("groups")) {
        return "has not been tried";
    }
    const int seeds = static_cast<int>(plan.last_seed - plan.first_seed) + 1;
    if (const int tried = times_tried(plan, entry); tried < seeds) {
        return "has been tried on " + std::to_string(tried) + " of " + std::to_string(seeds) + " seeds";
    }
    if (entry.value("decides", "") != hash_of_what_decides(exercise, root)) {
        return "is another exercise than the one that was tried";
    }
    if (entry.value("pass", -1.0) != gate.pass || entry.value("tells_apart", true) != gate.tells_apart) {
        return "has another gate than the one that was tried";
    }
    if (gate.reason.empty()) {
        return "its gate has no reason";
    }
    return gate.tells_apart && !comes_up(entry) ? "its gate does not tell beginners from experts, and says that it does"
                                                : "";
}

std::string passed_text(const json& entry, const std::string& group) {
    const json found = entry.at("groups").value(group, json());
    return found.is_object() ? found.at("passed").dump() + " of " + found.at("of").dump() : "-";
}

}  // namespace

Result<json> gates_tried(const StudyPlan& plan, const std::vector<StudyRun>& runs, const std::string& root) {
    const Result<records::Gates> gates = read_gates("", root);
    if (!gates) {
        return gates.error();
    }
    json tried = {
        {"note",
         "Attempts of virtual surgeons that pass the gates of rubrics/gates.json, on seeds that were run once, "
         "for this: `rhexis study " +
             plan.name + "`."},
        {"seeds", json::array()},
        {"exercises", json::object()}};
    for (std::uint64_t seed = plan.first_seed; seed <= plan.last_seed; ++seed) {
        tried["seeds"].push_back(seed);
    }
    for (const StudyRun& run : runs) {
        if (Status counted = count(run, gates.value(), root, tried["exercises"]); !counted) {
            return counted.error();
        }
    }
    return tried;
}

Result<json> earlier_seeds(const std::string& file, const StudyPlan& plan, const std::string& root) {
    const Result<records::Gates> gates = read_gates("", root);
    Result<json> earlier = read_json_file(file);
    if (!gates || !earlier) {
        return gates ? earlier : gates.error();
    }
    for (const json& seed : earlier.value().value("seeds", json::array())) {
        if (seed >= plan.first_seed && seed <= plan.last_seed) {
            return Error{"seed " + seed.dump() + " is in this table already", file, "--seeds, of others"};
        }
    }
    const json exercises = earlier.value().value("exercises", json::object());
    for (const StudyExercise& wanted : plan.exercises) {
        const std::string& name = wanted.exercise;
        const records::Gate& gate = gates.value().of(name);
        const json entry = exercises.value(name, json::object());
        if (entry.value("decides", "") != hash_of_what_decides(name, root) || entry.value("pass", -1.0) != gate.pass ||
            entry.value("tells_apart", true) != gate.tells_apart) {
            return Error{"the earlier seeds were tried with another exercise or gate: " + name, file,
                         "a table of what there is now"};
        }
    }
    return earlier;
}

void add_earlier(const json& earlier, json& tried) {
    for (auto& [exercise, entry] : tried["exercises"].items()) {
        for (auto& [name, group] : entry["groups"].items()) {
            const json& before = earlier.at("exercises").at(exercise).at("groups").value(name, json::object());
            for (const char* key : {"passed", "of"}) {
                group[key] = group.at(key).get<int>() + before.value(key, 0);
            }
        }
    }
    tried["seeds"].insert(tried["seeds"].end(), earlier.at("seeds").begin(), earlier.at("seeds").end());
    std::sort(tried["seeds"].begin(), tried["seeds"].end());
}

std::string gates_text(const json& tried) {
    std::string text = "| exercise | pass mark | group d passed | group a passed | |\n|---|---|---|---|---|\n";
    for (const auto& [exercise, entry] : tried.at("exercises").items()) {
        char mark[32];
        std::snprintf(mark, sizeof mark, "%.3g", entry.at("pass").get<double>());
        text += "| " + exercise + " | " + mark + " | " + passed_text(entry, "d") + " | " + passed_text(entry, "a") +
                " | " +
                (!entry.value("tells_apart", true) ? "says that it does not tell them apart"
                 : comes_up(entry)                 ? ""
                                                   : "does not tell them apart") +
                " |\n";
    }
    return text;
}

Result<std::vector<std::string>> gates_differences(const StudyPlan& plan, const std::string& root) {
    const Result<records::Gates> gates = read_gates("", root);
    const Result<json> kept = read_json_file(root + kept_file);
    if (!gates || !kept) {
        return gates ? kept.error() : gates.error();
    }
    const json tried = kept.value().value("exercises", json::object());
    std::vector<std::string> lines;
    int blind = 0;
    const std::vector<std::string> exercises = exercises_in(root);
    for (const std::string& exercise : exercises) {
        const records::Gate& gate = gates.value().of(exercise);
        const std::string what = difference(plan, exercise, tried.value(exercise, json()), gate, root);
        if (!what.empty()) {
            lines.push_back(exercise + ": " + what);
        }
        blind += gate.tells_apart ? 0 : 1;
    }
    if (3 * blind > static_cast<int>(exercises.size())) {
        lines.push_back(std::to_string(blind) + " of " + std::to_string(exercises.size()) +
                        " exercises say that they do not tell beginners from experts: at most a third may");
    }
    return lines;
}

}  // namespace rhexis::cli
