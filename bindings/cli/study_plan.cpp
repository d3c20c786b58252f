// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/operation_script.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t most_seeds = 1000;

/// Reads fields one after the other; the first mistake stays.
class Fields {
public:
    Fields(const json& object, std::string where) : object_(object), where_(std::move(where)) {}

    template <typename Value>
    Value get(const char* field, const char* wanted, bool (*good)(const json&), Value other, bool required) {
        known_.emplace_back(field);
        if (!object_.contains(field)) {
            if (required) {
                complain(field, "is missing", wanted);
            }
            return other;
        }
        if (!good(object_[field])) {
            complain(field, object_[field].dump().substr(0, 40), wanted);
            return other;
        }
        return object_[field].get<Value>();
    }

    Status finish() {
        for (const auto& [field, value] : object_.items()) {
            if (std::find(known_.begin(), known_.end(), field) == known_.end()) {
                complain(field.c_str(), "is no field of a study", suggestion(field, known_));
            }
        }
        return status_;
    }

    void complain(const std::string& field, const std::string& what, const std::string& allowed) {
        if (status_) {
            status_ = Error{field + ": " + what, where_, allowed};
        }
    }

private:
    const json& object_;
    std::string where_;
    std::vector<std::string> known_;
    Status status_ = success();
};

bool is_text(const json& value) { return value.is_string() && !value.get<std::string>().empty(); }
bool is_texts(const json& value) {
    return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_text);
}
bool is_yes_no(const json& value) { return value.is_boolean(); }
bool is_object(const json& value) { return value.is_object(); }
bool is_set(const json& value) { return value.is_object() && std::all_of(value.begin(), value.end(), is_text); }
bool is_range(const json& value) {
    return value.is_array() && value.size() == 2 && value[0].is_number_unsigned() && value[1].is_number_unsigned() &&
           value[0].get<std::uint64_t>() <= value[1].get<std::uint64_t>() &&
           value[1].get<std::uint64_t>() - value[0].get<std::uint64_t>() < most_seeds;
}
bool is_limit(const json& value) {
    return value.is_number() && value.get<double>() >= 0.1 && value.get<double>() <= 7200.0;
}
bool is_list(const json& value) {
    return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_object);
}

bool is_list_or_all(const json& value) { return value == "all" || is_list(value); }

/// Those of curricula/ that are no operations.
json all_exercises(const std::string& root) {
    json list = json::array();
    for (const std::string& name : curricula_in(root)) {
        const Result<std::optional<Operation>> operation = load_operation(name, root);
        if (!operation || !operation.value()) {  // one that cannot be read is told when its turn comes
            list.push_back({{"exercise", name}});
        }
    }
    return list;
}

Result<StudyExercise> exercise_from(const json& given, const std::string& where) {
    Fields fields(given, where);
    StudyExercise exercise;
    exercise.exercise = fields.get<std::string>("exercise", "a name in curricula/ or a folder", is_text, "", true);
    exercise.start = fields.get<std::string>("start", "a name in starts.lua", is_text, "", false);
    exercise.set =
        fields.get<std::map<std::string, std::string>>("set", "texts by name, as of --set", is_set, {}, false);
    const Status good = fields.finish();
    return good ? Result<StudyExercise>(exercise) : good.error();
}

}  // namespace

Result<StudyPlan> read_study(const std::string& name, const std::string& root) {
    const Result<std::string> path = find_json_file("study", name, root + "/studies");
    if (!path) {
        return path.error();
    }
    const Result<std::string> text = read_whole_file(path.value());
    if (!text) {
        return text.error();
    }
    const json given = json::parse(text.value(), nullptr, false);
    if (!given.is_object()) {
        return Error{"this is no JSON object", path.value(), "a study, as studies/part_exercises.json"};
    }
    Fields fields(given, path.value());
    StudyPlan plan;
    plan.name = fs::path(path.value()).stem().string();
    plan.title = fields.get<std::string>("title", "a text", is_text, "", true);
    plan.groups =
        fields.get<std::vector<std::string>>("groups", "names of surgeons, as [\"a\", \"d\"]", is_texts, {}, true);
    const auto seeds =
        fields.get<std::vector<std::uint64_t>>("seeds", "[first, last], at most 1000", is_range, {0, 0}, true);
    plan.first_seed = seeds[0];
    plan.last_seed = seeds[1];
    plan.limit_s = fields.get<double>("limit_s", "0.1 to 7200", is_limit, 90.0, false);
    plan.reference = fields.get<bool>("reference", "true or false", is_yes_no, false, false);
    plan.gates = fields.get<bool>("gates", "true or false", is_yes_no, false, false);
    plan.published = fields.get<json>("published", "an object with source and groups", is_object, nullptr, false);
    const json exercises =
        fields.get<json>("exercises", "a list of objects, or \"all\"", is_list_or_all, json::array(), true);
    for (const json& entry : exercises == "all" ? all_exercises(root) : exercises) {
        Result<StudyExercise> exercise =
            exercise_from(entry, path.value() + ", exercise " + std::to_string(plan.exercises.size() + 1));
        if (!exercise) {
            return exercise.error();
        }
        plan.exercises.push_back(std::move(exercise).value());
    }
    const Status good = fields.finish();
    return good ? Result<StudyPlan>(plan) : good.error();
}

}  // namespace rhexis::cli
