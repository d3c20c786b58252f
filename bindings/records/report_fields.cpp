// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/report_fields.hpp"

#include <cmath>
#include <map>

namespace rhexis::records {
namespace {

using nlohmann::json;

std::string text_in(const json& object, const char* key) {
    return object.is_object() && object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

std::optional<double> number_in(const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_number()) {
        return std::nullopt;
    }
    const double value = object[key].get<double>();
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

const json& list_in(const json& object, const char* key) {
    static const json none = json::array();
    return object.is_object() && object.contains(key) && object[key].is_array() ? object[key] : none;
}

std::string joined(const json& words) {
    std::string all;
    for (const json& word : words) {
        if (word.is_string()) {
            all.append(all.empty() ? "" : " ").append(word.get<std::string>());
        }
    }
    return all;
}

void take_items(const json& osacss, Attempt& attempt, std::map<std::string, MeasureValue>& measures) {
    std::map<std::string, ItemScore> items;
    for (const json& item : list_in(osacss, "items")) {
        const std::string id = text_in(item, "id");
        items[id] = {id, text_in(item, "name"), number_in(item, "score"), joined(list_in(item, "capped_by"))};
        for (const json& measure : list_in(item, "measures")) {
            const std::string name = text_in(measure, "id");
            measures[name] = {name, text_in(measure, "name"), number_in(measure, "value"), text_in(measure, "unit"),
                              number_in(measure, "score")};
        }
    }
    for (auto& [id, item] : items) {
        attempt.items.push_back(std::move(item));
    }
}

void take_measures(const json& report, Attempt& attempt, std::map<std::string, MeasureValue>& measures) {
    const json all = report.value("measures", json::object());
    for (const auto& [id, value] : all.items()) {
        if (!measures.contains(id)) {
            measures[id] = {id, "", number_in(all, id.c_str()), "", std::nullopt};
        }
    }
    for (auto& [id, measure] : measures) {
        attempt.measures.push_back(std::move(measure));
    }
}

void take_events(const json& report, Attempt& attempt) {
    for (const json& event : list_in(report, "events")) {
        attempt.events.push_back({number_in(event, "time_s").value_or(0.0), text_in(event, "step"),
                                  text_in(event, "id"), text_in(event, "severity"),
                                  event.is_object() && event.contains("recovered") && event["recovered"] == true,
                                  number_in(event, "recovery_s")});
    }
}

}  // namespace

Status take_report(const json& report, Attempt& attempt) {
    if (!report.is_object() || report.value("schema", json()) != 1 || !report.value("curriculum", json()).is_object()) {
        return Error{"this is no report of schema 1", attempt.folder + "/report.json", "the folder of a run"};
    }
    const json& curriculum = report["curriculum"];
    attempt.exercise = text_in(curriculum, "id");
    attempt.title = text_in(curriculum, "title");
    attempt.version = number_in(curriculum, "version").value_or(0.0);
    attempt.sha256 = text_in(curriculum, "sha256");
    attempt.surgeon = text_in(report, "surgeon");
    attempt.seed = report.value("seed", json()).is_number_unsigned() ? report["seed"].get<std::uint64_t>() : 0;
    attempt.completed = report.value("completed", json()) == true;
    attempt.duration_s = number_in(report, "duration_s").value_or(0.0);
    attempt.patient = report.value("patient", json::object()).dump();
    attempt.settings = report.value("set", json::object()).dump();
    attempt.level = text_in(report, "level");
    attempt.mode = text_in(report, "mode");
    attempt.language = text_in(report, "language");
    attempt.error = text_in(report, "error");
    attempt.begun_at = text_in(report, "begun_at");
    attempt.input = text_in(report, "input");
    attempt.aids.clear();
    for (const json& aid : list_in(report, "aids")) {
        attempt.aids += (attempt.aids.empty() ? "" : " ") + text_in(aid, "id");
    }
    const json osacss = report.value("osacss", json());
    attempt.rubric = text_in(osacss, "rubric");
    attempt.total = number_in(osacss, "total");
    attempt.max = number_in(osacss, "max");
    attempt.scaled = number_in(osacss, "scaled");
    attempt.items.clear();
    attempt.measures.clear();
    attempt.events.clear();
    std::map<std::string, MeasureValue> measures;
    take_items(osacss, attempt, measures);
    take_measures(report, attempt, measures);
    take_events(report, attempt);
    return success();
}

json note_of(const Attempt& a) {
    return {
        {"schema", 1},          {"attempt", a.id},    {"trainee", a.trainee.pseudonym}, {"cohort", a.trainee.cohort},
        {"arm", a.trainee.arm}, {"begun", a.begun},   {"exercise", a.exercise},         {"title", a.title},
        {"version", a.version}, {"sha256", a.sha256}, {"surgeon", a.surgeon},           {"seed", a.seed}};
}

Result<Attempt> attempt_from_note(const json& note, const std::string& where) {
    Attempt a;
    a.id = text_in(note, "attempt");
    a.trainee = {text_in(note, "trainee"), text_in(note, "cohort"), text_in(note, "arm")};
    a.begun = text_in(note, "begun");
    a.exercise = text_in(note, "exercise");
    a.title = text_in(note, "title");
    a.version = number_in(note, "version").value_or(0.0);
    a.sha256 = text_in(note, "sha256");
    a.surgeon = text_in(note, "surgeon");
    a.seed =
        note.is_object() && note.value("seed", json()).is_number_unsigned() ? note["seed"].get<std::uint64_t>() : 0;
    if (a.id.empty() || a.trainee.pseudonym.empty()) {
        return Error{"this is no note of an attempt", where, "attempt.json as rhexis run --trainee writes it"};
    }
    return a;
}

}  // namespace rhexis::records
