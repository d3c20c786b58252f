// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/records_json.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json parsed(const std::string& text) {
    const json value = json::parse(text, nullptr, false);
    return value.is_discarded() ? json(nullptr) : value;
}

void add_details(json& out, const records::Attempt& a) {
    for (const records::ItemScore& item : a.items) {
        out["items"].push_back({{"id", item.id},
                                {"name", item.name},
                                {"score", number_or_null(item.score)},
                                {"capped_by", item.capped_by}});
    }
    for (const records::MeasureValue& measure : a.measures) {
        out["measures"].push_back({{"id", measure.id},
                                   {"name", measure.name},
                                   {"value", number_or_null(measure.value)},
                                   {"unit", measure.unit},
                                   {"score", number_or_null(measure.score)}});
    }
    for (const records::EventRow& event : a.events) {
        out["events"].push_back({{"id", event.id},
                                 {"time_s", event.time_s},
                                 {"step", event.step},
                                 {"severity", event.severity},
                                 {"recovered", event.recovered},
                                 {"recovery_s", number_or_null(event.recovery_s)}});
    }
}

}  // namespace

const char* state_name(records::AttemptState state) {
    switch (state) {
        case records::AttemptState::running:
            return "running";
        case records::AttemptState::interrupted:
            return "interrupted";
        case records::AttemptState::finished:
            return "finished";
    }
    return "finished";
}

json attempt_json(const records::Attempt& a) {
    json out = {{"attempt", a.id},
                {"state", state_name(a.state)},
                {"trainee", a.trainee.pseudonym},
                {"cohort", a.trainee.cohort},
                {"arm", a.trainee.arm},
                {"exercise", a.exercise},
                {"title", a.title},
                {"version", a.version},
                {"sha256", a.sha256},
                {"surgeon", a.surgeon},
                {"seed", a.seed},
                {"begun", a.begun},
                {"ended", a.ended},
                {"completed", a.completed},
                {"duration_s", a.duration_s},
                {"patient", parsed(a.patient)},
                {"settings", parsed(a.settings)},
                {"level", a.level},
                {"mode", a.mode},
                {"language", a.language},
                {"rubric", a.rubric},
                {"total", number_or_null(a.total)},
                {"max", number_or_null(a.max)},
                {"scaled", number_or_null(a.scaled)},
                {"begun_at", a.begun_at},
                {"input", a.input},
                {"aids", a.aids},
                {"error", a.error},
                {"folder", a.folder},
                {"recording_sha256", a.recording_sha256}};
    add_details(out, a);
    return out;
}

}  // namespace rhexis::cli
