// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh, step and way of a scene, from the error that it may make: the cheapest that keeps it, by committed tables.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/scene.hpp"
#include "session/accuracy_table.hpp"

namespace rhexis {

/// What an exercise says of it.
struct AccuracyWish {
    std::map<std::string, double> budget;  ///< by quantity, in place of what its tissues keep by themselves
    std::optional<double> step_s;          ///< by hand
    std::set<std::string> by_hand;         ///< meshes that the scene has from the exercise: "patient.tetrahedra"
    std::string where;                     ///< of the budget, for messages: "groove/curriculum.lua:20"
};

/// The models of a scene that have a table.
std::vector<std::string> accuracy_models_of(const SceneDescription& scene);

/// The tables of those models, from a folder of them.
Result<std::vector<AccuracyTable>> read_accuracy_tables(const std::string& folder, const SceneDescription& scene);

/// The step that all models share, at most what `time` allows, and a mesh and way for each, so that all errors are kept
/// at the least cost of all models together; of equals the longer step and the coarser mesh. What is said by hand
/// stays, whatever error it makes. Depends on nothing but its arguments. Fails on a quantity that nothing in the scene
/// is judged by, and on a budget that no mesh and step keeps, with the nearest there is.
Result<SceneAccuracy> choose_accuracy(const SceneDescription& scene, const AccuracyWish& wish,
                                      const std::vector<AccuracyTable>& tables);

/// Makes the scene what was chosen.
void set_accuracy(const SceneAccuracy& accuracy, SceneDescription& scene);

}  // namespace rhexis
