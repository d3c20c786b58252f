// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/exercise_instruments.hpp"

#include <algorithm>

#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"

namespace rhexis {

Result<std::vector<std::string>> instruments_of(const std::string& exercise, const std::string& root) {
    const Result<std::optional<Operation>> operation = load_operation(exercise, root);
    if (!operation) {
        return operation.error();
    }
    std::vector<ExerciseOptions> scenes;
    if (operation.value()) {
        int index = 0;
        for (const OperationPart& part : operation.value()->parts) {
            scenes.push_back({part.exercise, "none", 1, {}, root, PartPlace{exercise, ++index}});
        }
    } else {
        scenes.push_back({exercise, "none", 1, {}, root});
    }
    std::vector<std::string> names;
    for (const ExerciseOptions& scene : scenes) {
        const Result<ExerciseHost> host = ExerciseHost::load(scene);
        if (!host) {
            return host.error();
        }
        for (const std::string& name : host.value().scene().instruments) {
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

}  // namespace rhexis
