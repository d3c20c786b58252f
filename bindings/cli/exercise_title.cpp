// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exercise_title.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"

namespace rhexis::cli {
namespace {

/// "" where the exercise has mistakes, or no texts in that language.
std::string own_title(const std::string& id, const std::string& language, const std::string& root) {
    const std::string folder = root + "/curricula/" + id;  // by its bare name one in the working folder goes before it
    const Result<std::optional<Operation>> operation = load_operation(folder, root, language);
    if (operation && operation.value()) {
        return operation.value()->identity.value("title", "");
    }
    ExerciseOptions options;
    options.curriculum = folder;
    options.root = root;
    options.set["language"] = language.empty() ? "en" : language;
    const Result<ExerciseHost> host = ExerciseHost::load(options);
    return host ? host.value().identity().value("title", "") : "";
}

}  // namespace

std::string title_in(const std::string& language, const NamedExercise& exercise, const std::string& root) {
    const std::vector<std::string> known = curricula_in(root);
    if (std::find(known.begin(), known.end(), exercise.id) == known.end() ||
        own_title(exercise.id, exercise.language, root) != exercise.title) {  // another exercise of this name
        return exercise.title;
    }
    const std::string title = own_title(exercise.id, language, root);
    return title.empty() ? exercise.title : title;
}

std::string title_of(const std::string& exercise, const std::string& language, const std::string& root) {
    const std::string title = own_title(exercise, language, root);
    return title.empty() ? exercise : title;
}

}  // namespace rhexis::cli
