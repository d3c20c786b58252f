// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rated_case.hpp"

#include <filesystem>

#include "cli/exercise_title.hpp"
#include "records/report_fields.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {

nlohmann::json case_of_run(const std::string& run, const std::string& language, const std::string& root) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path folder = fs::is_directory(run, ignored) ? fs::path(run) : fs::path(run).parent_path();
    const Result<nlohmann::json> report = read_json_file((folder / "report.json").string());
    records::Attempt attempt;
    nlohmann::json told = nlohmann::json::object();
    if (!report || !records::take_report(report.value(), attempt)) {
        return told;
    }
    if (!attempt.title.empty()) {
        told["title"] = title_in(language, {attempt.exercise, attempt.title, attempt.language}, root);
    }
    if (attempt.rubric == "OSACSS") {
        told["items"] = nlohmann::json::array();
        for (const records::ItemScore& item : attempt.items) {
            told["items"].push_back(item.id);
        }
    }
    return told;
}

}  // namespace rhexis::cli
