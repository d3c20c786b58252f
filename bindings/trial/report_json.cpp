// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/report_json.hpp"

#include "base/hash.hpp"

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

}  // namespace

json make_report(const ReportInput& input) {
    json report = input.result.is_object() ? input.result : json::object();
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
    report["curriculum"] = curriculum_json(input.identity);
    report["surgeon"] = input.surgeon;
    if (!input.device.empty()) {
        report["input"] = input.device;
    }
    report["set"] = json(input.set);
    report["seed"] = input.seed;
    report["start"] = input.start.empty() ? json(nullptr) : json(input.start);
    report["begun_at"] = input.begun_at.empty() ? json(nullptr) : json(input.begun_at);
    report["opening_mm"] = input.opening.empty() ? json(nullptr) : json(input.opening);
    report["opening_note"] = input.opening_note.empty() ? json(nullptr) : json(input.opening_note);
    report["patient"] = patient_json(input.patient);
    report["duration_s"] = input.duration_s;
    report["state_hash"] = hex(input.state_hash);
    report["pictures"] = pictures_json(input.pictures);
    report["video"] = input.video ? json("video.mp4") : json(nullptr);
    report["log"] = log_json(input.log);
    report["simulated"] = input.simulated;
    report["performance"] = input.performance;
    if (!input.script_error.empty()) {
        report["error"] = input.script_error;
        report["completed"] = false;
    }
    return report;
}

std::string score_line(const json& report) {
    const json osacss = report.value("osacss", json(nullptr));
    if (!osacss.is_object() || !osacss.contains("total") || !osacss["total"].is_number()) {
        return "no score: the exercise was not judged";
    }
    char text[128];
    const double scaled =
        osacss.contains("scaled") && osacss["scaled"].is_number() ? osacss["scaled"].get<double>() : 0.0;
    const bool broken_off = report.value("completed", json()) == false;
    std::snprintf(text, sizeof text, "%s %g of %g%s (scaled %.2f; not clinically validated)",
                  osacss.value("rubric", "OSACSS").c_str(), osacss["total"].get<double>(), osacss.value("max", 0.0),
                  broken_off ? " for what was done" : "", scaled);
    return text;
}

}  // namespace rhexis
