// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/cohorts.hpp"

#include <filesystem>

#include "base/text_file.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{4} << 20;

bool is_cohort(const json& entry) {
    return entry.is_object() && entry.value("decides", json()).is_string() &&
           entry.value("rubric", json()).is_string() && entry.value("items", json()).is_array() &&
           entry.value("cuts", json()).is_array();
}

}  // namespace

Result<json> reference_cohort(const CurriculumFiles& files, const std::string& root) {
    const std::string path = root + "/rubrics/cohorts.json";
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        return json();
    }
    const Result<std::string> text = read_text_file(path, most_bytes);
    if (!text) {
        return text.error();
    }
    const json all = json::parse(text.value(), nullptr, false);
    const json exercises = all.is_object() ? all.value("exercises", json()) : json();
    if (!exercises.is_object()) {
        return Error{"these are no cohorts", path, "as rhexis study cohort writes them"};
    }
    json entry = exercises.value(files.id, json());
    if (entry.is_null()) {
        return entry;
    }
    if (!is_cohort(entry)) {
        return Error{"the cohort of " + files.id + " is not whole", path, "as rhexis study cohort writes it"};
    }
    if (entry["decides"] != hash_of_what_decides(files.folder, root)) {
        entry["stale"] = true;
    }
    return entry;
}

}  // namespace rhexis
