// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/scenario_files.hpp"

#include <algorithm>
#include <filesystem>

#include "base/near_names.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/scenario_script.hpp"

namespace rhexis {
namespace {

namespace fs = std::filesystem;

bool has_curriculum(const fs::path& folder) {
    std::error_code failed;
    return fs::is_regular_file(folder / "curriculum.lua", failed);
}

/// The nearest folder above a file that holds an exercise; empty: none.
fs::path exercise_above(const std::string& path) {
    fs::path folder = fs::weakly_canonical(path).parent_path();
    while (!has_curriculum(folder)) {
        if (folder == folder.parent_path()) {
            return {};
        }
        folder = folder.parent_path();
    }
    return folder;
}

/// named: what the file calls its exercise, or null.
Result<std::string> exercise_of(const std::string& path, const nlohmann::json& named) {
    const fs::path above = exercise_above(path);
    if (!named.is_string()) {
        if (above.empty()) {
            return Error{"the scenarios do not say of which exercise they are", path,
                         "return scenarios \"groove\" { ... }, or a file in the folder of an exercise"};
        }
        return above.string();
    }
    const std::string name = named;
    if (!above.empty() && above.filename() == name) {
        return above.string();
    }
    const fs::path beside = fs::path(path).parent_path() / name;
    return has_curriculum(beside) ? beside.string() : name;
}

}  // namespace

std::vector<std::string> scenarios_below(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code failed;
    for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        // made absolute, so that the folder "." inside tests/ is known as such
        if (at->is_regular_file(failed) && is_scenario_file(fs::absolute(at->path()).lexically_normal().string())) {
            paths.push_back(at->path().lexically_normal().string());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

Result<std::vector<std::string>> scenario_paths(const std::string& given, const std::string& root) {
    std::error_code failed;
    if (fs::is_regular_file(given, failed)) {
        return std::vector<std::string>{given};
    }
    fs::path folder = given;
    if (!fs::is_directory(folder, failed)) {
        const std::vector<std::string> known = curricula_in(root);
        if (std::find(known.begin(), known.end(), given) == known.end()) {
            return Error{"there is no such file, folder or exercise" + did_you_mean(given, known), given,
                         "a scenario file, a folder, or a name in curricula/"};
        }
        folder = fs::path(root) / "curricula" / given / "tests";
    }
    std::vector<std::string> paths = scenarios_below(folder.string());
    if (paths.empty()) {
        return Error{"there are no scenario tests here", folder.string(), "tests/*.lua or *_test.lua"};
    }
    return paths;
}

Result<ScenarioFile> read_scenarios(const std::string& path, const std::string& root) {
    const Result<ScenarioScript> script = ScenarioScript::load(path, "scenarios", root);
    if (!script) {
        return script.error();
    }
    const Result<std::string> curriculum =
        exercise_of(path, script.value().listing().value("exercise", nlohmann::json()));
    if (!curriculum) {
        return curriculum.error();
    }
    const Result<CurriculumFiles> files = find_curriculum(curriculum.value(), root);
    if (!files) {
        return Error{files.error().what, path, files.error().allowed};
    }
    return ScenarioFile{path, script.value().chunk(), files.value().script, files.value().id,
                        script.value().listing().at("list")};
}

std::string place_in_file(const ScenarioFile& file, const std::string& where) {
    return where.starts_with(file.chunk + ":") ? file.path + where.substr(file.chunk.size()) : where;
}

}  // namespace rhexis
