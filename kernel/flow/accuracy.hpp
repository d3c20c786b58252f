// SPDX-License-Identifier: GPL-3.0-or-later
// curriculum -> session, recording and report: how finely a scene is simulated, and what error that is expected to
// make.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rhexis {

/// One model of a scene, such as the lens. Quantities: session/accuracy_quantities.hpp.
struct ModelAccuracy {
    std::string model;                       ///< name of its table: "lens"
    std::string way;                         ///< how it is advanced; empty: there is one way
    std::map<std::string, double> mesh;      ///< what decides how fine it is: "patient.tetrahedra" = 6000
    std::map<std::string, double> budget;    ///< error that may be made, by quantity
    std::map<std::string, double> expected;  ///< error by the table, likewise; what it does not know is left out
    double cost = 0.0;                       ///< by the table [CPU s per simulated s]
    bool by_hand = false;                    ///< the exercise says itself how fine it is
    std::map<std::string, double> instead;   ///< by hand: what the budget alone would take; empty: no mesh keeps it
    std::string machine;                     ///< that the cost was measured on
};

/// Of a scene that nobody chose for, such as one that C++ builds, there are no models.
struct SceneAccuracy {
    double step_s = 0.0;  ///< 0: nobody chose
    bool step_by_hand = false;
    double time_s = 0.0;  ///< how late a step may tell what happened in it
    std::vector<ModelAccuracy> models;
};

/// By the tables, of all models [CPU s per simulated s].
inline double expected_cost(const SceneAccuracy& accuracy) {
    double cost = 0.0;
    for (const ModelAccuracy& model : accuracy.models) {
        cost += model.cost;
    }
    return cost;
}

}  // namespace rhexis
