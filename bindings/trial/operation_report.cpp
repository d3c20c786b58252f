// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/operation_report.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "trial/operation.hpp"
#include "trial/places.hpp"
#include "trial/report_json.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

constexpr std::size_t most_moments = 1500;  ///< of the series of the whole

/// Measures of all parts, one after the other; null where a part has no such measure.
class WholeSeries {
public:
    void add(const json& part, double since_s, std::size_t stride) {
        const json& times = part.at("time_s");
        for (const auto& [name, measure] : part.at("measures").items()) {
            json& own = measures_[name];
            if (own.is_null()) {
                own = {{"unit", measure.at("unit")}, {"meaning", measure.at("meaning")}, {"values", json::array()}};
            }
            fill(own["values"], times_.size());
            for (std::size_t i = 0; i < times.size(); i += stride) {
                own["values"].push_back(measure.at("values").at(i));
            }
        }
        for (std::size_t i = 0; i < times.size(); i += stride) {
            times_.push_back(since_s + times.at(i).get<double>());
        }
    }

    json finish() {
        json all = json::object();
        for (auto& [name, measure] : measures_) {
            fill(measure["values"], times_.size());
            all[name] = std::move(measure);
        }
        return {{"schema", 1}, {"time_s", times_}, {"measures", all}};
    }

private:
    static void fill(json& values, std::size_t size) {
        while (values.size() < size) {
            values.push_back(nullptr);
        }
    }

    std::vector<double> times_;
    std::map<std::string, json> measures_;
};

/// Lists of a part with its times on the clock of the whole.
void append_shifted(json& list, const json& given, double since_s, const std::string& part) {
    for (json entry : given) {
        entry["part"] = part;
        entry["time_s"] = since_s + entry.value("time_s", 0.0);
        list.push_back(std::move(entry));
    }
}

void append_pictures(json& list, const json& report, double since_s, const DonePart& part, const std::string& folder) {
    const std::string title = report.value("title", part.title);
    json own = report.value("pictures", json::array());
    for (json& picture : own) {
        const std::filesystem::path file = std::filesystem::path(part.folder) / picture.value("file", "");
        picture["file"] = file.lexically_relative(folder).generic_string();
        picture["caption"] = title + ": " + picture.value("caption", "");
    }
    append_shifted(list, own, since_s, part.id);
}

/// What is the same in every part, from the last one that told it.
json told_by_parts(const std::vector<json>& reports) {
    json told = json::object();
    for (const json& report : reports) {
        for (const char* key : {"language", "mode", "hints", "orientation"}) {
            if (report.contains(key)) {
                told[key] = report.at(key);
            }
        }
    }
    return told;
}

/// Work of all parts; what is simulated in several counts once, with the sum of its time.
class Work {
public:
    void add(const json& report) {
        for (const json& part : report.value("simulated", json::array())) {
            json& own = parts_[part.value("part", "")];
            own["part"] = part.value("part", "");
            own["elements"] = std::max(own.value("elements", 0.0), part.value("elements", 0.0));
            own["cpu_s"] = own.value("cpu_s", 0.0) + part.value("cpu_s", 0.0);
        }
        const json performance = report.value("performance", json::object());
        const double steps = performance.value("steps", 0.0);
        steps_ += steps;
        wall_ms_ += steps * performance.value("mean_step_ms", 0.0);
        p99_ = std::max(p99_, performance.value("p99_step_ms", 0.0));
        rollbacks_ += performance.value("rollbacks", 0.0);
        const double duration_s = report.value("duration_s", 0.0);
        duration_s_ += duration_s;
        cpu_s_ += duration_s * performance.value("cpu_s_per_s", 0.0);
    }

    [[nodiscard]] json simulated() const {
        json list = json::array();
        for (const auto& [name, part] : parts_) {
            list.push_back(part);
        }
        return list;
    }

    [[nodiscard]] json performance() const {
        return {{"steps", steps_},
                {"cpu_s_per_s", duration_s_ > 0.0 ? cpu_s_ / duration_s_ : 0.0},
                {"mean_step_ms", steps_ > 0.0 ? wall_ms_ / steps_ : 0.0},
                {"p99_step_ms", p99_},  // of the slowest part
                {"rollbacks", rollbacks_}};
    }

    [[nodiscard]] double duration_s() const { return duration_s_; }

private:
    std::map<std::string, json> parts_;
    double steps_ = 0.0;
    double wall_ms_ = 0.0;
    double p99_ = 0.0;
    double rollbacks_ = 0.0;
    double duration_s_ = 0.0;
    double cpu_s_ = 0.0;
};

json part_line(const DonePart& part, const json& report, const std::string& folder) {
    return {{"id", part.id},
            {"title", report.value("title", json(part.title))},
            {"folder", std::filesystem::path(part.folder).lexically_relative(folder).generic_string()},
            {"curriculum", report.value("curriculum", json())},
            {"completed", report.value("completed", false)},
            {"duration_s", report.value("duration_s", 0.0)},
            {"state_hash", report.value("state_hash", json())},
            {"opening_note", report.value("opening_note", json())},
            {"score", score_line(report)}};
}

}  // namespace

Result<WholeReport> report_of_parts(const OperationOptions& options, const std::vector<DonePart>& parts,
                                    const std::string& script_error) {
    json pictures = json::array();
    json log = json::array();
    json lines = json::array();
    json patient = nullptr;
    Work work;
    WholeSeries series;
    std::vector<json> all_series;
    std::vector<json> reports;
    std::size_t moments = 0;
    for (const DonePart& part : parts) {
        const Result<json> report = read_json_file(part.folder + "/report.json");
        const Result<json> own_series = read_json_file(part.folder + "/series.json");
        if (!report || !own_series) {
            return report ? own_series.error() : report.error();
        }
        const double since_s = work.duration_s();
        append_pictures(pictures, report.value(), since_s, part, options.attempt.folder);
        append_shifted(log, report.value().value("log", json::array()), since_s, part.id);
        lines.push_back(part_line(part, report.value(), options.attempt.folder));
        patient = patient.is_null() ? report.value().value("patient", json()) : patient;
        work.add(report.value());
        moments += own_series.value().at("time_s").size();
        all_series.push_back(own_series.value());
        reports.push_back(report.value());
    }
    const std::size_t stride = std::max<std::size_t>(1, (moments + most_moments - 1) / most_moments);
    double since_s = 0.0;
    for (std::size_t i = 0; i < all_series.size(); ++i) {
        series.add(all_series[i], since_s, stride);
        since_s += lines[i].value("duration_s", 0.0);
    }
    AttemptFacts facts;
    facts.identity = options.operation.identity;
    facts.surgeon = options.attempt.exercise.surgeon;
    facts.set = options.attempt.exercise.set;
    facts.seed = options.attempt.exercise.seed;
    const bool from_later = !parts.empty() && parts.front().id != options.operation.parts.front().id;
    facts.begun_at = from_later ? parts.front().id : "";
    facts.duration_s = work.duration_s();
    facts.findings = parts.empty() ? json::object() : parts.back().left;
    facts.findings.erase("carried");
    facts.findings.erase("fingerprint");
    facts.findings.update(told_by_parts(reports));
    facts.findings["title"] = options.operation.identity.at("title");
    facts.findings["summary"] = options.operation.summary;
    facts.findings["objectives"] = options.operation.objectives;
    facts.script_error = script_error;
    json report = make_report(facts);
    report["simulated"] = work.simulated();
    report["performance"] = work.performance();
    const bool all_done = parts.size() == options.operation.parts.size();
    report["completed"] = report["completed"] == true && all_done;
    report["parts"] = lines;
    report["patient"] = patient;
    report["pictures"] = pictures;
    report["log"] = log;
    report.erase("state_hash");  // each part has its own
    return WholeReport{report, series.finish()};
}

}  // namespace rhexis
