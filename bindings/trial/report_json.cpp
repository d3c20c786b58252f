// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/report_json.hpp"

#include <cmath>
#include <cstdio>

#include "base/hash.hpp"
#include "lua/accuracy_words.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

json patient_json(const Patient& patient) {
    return {{"age", patient.age},
            {"nuclear_grade", patient.nuclear_grade},
            {"cortical_opacity", patient.cortical_opacity},
            {"pupil_mm", patient.pupil_mm},
            {"side", patient.side},
            {"tetrahedra", patient.tetrahedra}};
}

json pictures_json(const std::vector<Picture>& pictures) {
    json list = json::array();
    for (const Picture& picture : pictures) {
        list.push_back(
            {{"file", picture.file}, {"name", picture.name}, {"caption", picture.caption}, {"time_s", picture.time_s}});
    }
    return list;
}

const char* level_name(LogLevel level) {
    switch (level) {
        case LogLevel::info:
            return "info";
        case LogLevel::warning:
            return "warning";
        case LogLevel::error:
            return "error";
    }
    return "info";
}

json log_json(const Log& log) {
    json list = json::array();
    for (const LogLine& line : log) {
        list.push_back({{"level", level_name(line.level)}, {"time_s", line.time_s}, {"text", line.text}});
    }
    return list;
}

json curriculum_json(const json& identity) {
    json part = json::object();
    for (const char* key : {"id", "title", "version", "sha256"}) {
        if (identity.contains(key)) {
            part[key] = identity[key];
        }
    }
    return part;
}

double five_places(double value) { return std::round(value * 1e5) / 1e5; }

json simulated_json(const std::vector<SimulatedPart>& parts) {
    json list = json::array();
    for (const SimulatedPart& part : parts) {
        list.push_back({{"part", part.part}, {"elements", part.elements}, {"cpu_s", five_places(part.cpu_s)}});
    }
    return list;
}

json performance_json(const Performance& cost) {
    json part = {{"steps", cost.steps},
                 {"cpu_s_per_s", five_places(cost.cpu_s_per_s)},
                 {"mean_step_ms", five_places(cost.mean_step_ms)},
                 {"p99_step_ms", five_places(cost.p99_step_ms)},
                 {"worst_step_ms", five_places(cost.worst_step_ms)},
                 {"rollbacks", cost.rollbacks},
                 {"checkpoints",
                  {{"count", cost.checkpoints.count},
                   {"worst_taking_ms", five_places(cost.checkpoints.worst_taking_ms)},
                   {"worst_writing_ms", five_places(cost.checkpoints.worst_writing_ms)}}}};
    if (cost.live) {
        part["live"] = {{"late_p99_9_steps", five_places(cost.live->late_p99_9_steps)},
                        {"slowed_share", five_places(cost.live->slowed_share)},
                        {"steal_s", cost.live->steal_s},
                        {"pictures_per_s", five_places(cost.live->pictures_per_s)}};
    }
    return part;
}

json link_json(const LinkFigures& link) {
    return {{"name", link.name},
            {"steps", link.steps},
            {"stood", link.stood},
            {"present", link.present},
            {"unseen", link.unseen},
            {"rms_mm", five_places(link.rms_mm)},
            {"farthest_mm", five_places(link.farthest_mm)}};
}

double number_in(const json& object, const char* name) {
    return object.contains(name) && object[name].is_number() ? object[name].get<double>() : 0.0;
}

}  // namespace

json make_report(const AttemptFacts& facts) {
    json report = facts.findings.is_object() ? facts.findings : json::object();
    const json defaults = {{"completed", false},
                           {"steps", json::array()},
                           {"events", json::array()},
                           {"osacss", nullptr},
                           {"measures", json::object()}};
    for (const auto& [key, value] : defaults.items()) {
        if (!report.contains(key)) {
            report[key] = value;
        }
    }
    report["schema"] = report_schema;
    report["clinically_validated"] = false;
    report["curriculum"] = curriculum_json(facts.identity);
    report["surgeon"] = facts.surgeon;
    if (!facts.device.empty()) {
        report["input"] = facts.device;
    }
    report["set"] = json(facts.set);
    report["seed"] = facts.seed;
    report["start"] = facts.start.empty() ? json(nullptr) : json(facts.start);
    report["begun_at"] = facts.begun_at.empty() ? json(nullptr) : json(facts.begun_at);
    report["opening_mm"] = facts.opening.empty() ? json(nullptr) : json(facts.opening);
    report["opening_note"] = facts.opening_note.empty() ? json(nullptr) : json(facts.opening_note);
    report["patient"] = patient_json(facts.patient);
    report["accuracy"] = accuracy_json(facts.accuracy);
    report["accuracy"]["measured"] = facts.measured;
    report["duration_s"] = facts.duration_s;
    report["state_hash"] = hex(facts.state_hash);
    report["pictures"] = pictures_json(facts.pictures);
    report["video"] = facts.video ? json("video.mp4") : json(nullptr);
    report["log"] = log_json(facts.log);
    report["simulated"] = simulated_json(facts.simulated);
    report["performance"] = performance_json(facts.performance);
    if (facts.link) {
        report["link"] = link_json(*facts.link);
    }
    if (!facts.script_error.empty()) {
        report["error"] = facts.script_error;
        report["completed"] = false;
    }
    return report;
}

std::optional<Score> score_in(const json& report) {
    const json osacss = report.value("osacss", json(nullptr));
    if (!osacss.is_object() || !osacss.contains("total") || !osacss["total"].is_number()) {
        return std::nullopt;
    }
    return Score{osacss.value("rubric", "OSACSS"), number_in(osacss, "total"), number_in(osacss, "max"),
                 number_in(osacss, "scaled")};
}

std::string score_line(const std::optional<Score>& score, bool completed) {
    if (!score) {
        return "no score: the exercise was not judged";
    }
    char text[128];
    std::snprintf(text, sizeof text, "%s %g of %g%s (scaled %.2f; not clinically validated)", score->rubric.c_str(),
                  score->total, score->max, completed ? "" : " for what was done", score->scaled);
    return text;
}

std::string score_line(const json& report) {
    return score_line(score_in(report), report.value("completed", json()) != false);
}

}  // namespace rhexis
