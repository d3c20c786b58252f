// SPDX-License-Identifier: GPL-3.0-or-later
// curriculum -> session: what an exercise asks for. What it does not name is not built, stepped or drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flow/accuracy.hpp"
#include "flow/eye_model.hpp"

namespace rhexis {

struct SceneDescription {
    Patient patient;
    std::vector<std::string> tissues;        ///< names: session/scene_check.cpp
    std::vector<std::string> instruments;    ///< names: tools/instruments.hpp; their order is the index
    double step_s = 0.01;                    ///< [s], 0.001 to 0.02
    Advance advance = Advance::automatic;    ///< of the lens
    std::vector<double> opening{};           ///< of a bag that an implant is laid into: how far its edge is from the
                                             ///< axis [mm], eye/empty_bag.hpp; none: capsulorhexis.diameter_mm
    bool lens_by_points = true;              ///< SolidModel::by_points of the lens, explicit only; not recorded
    int threads = 1;                         ///< 1 to 64
    std::string instruction_set;             ///< "": the best; "baseline", "avx2", "avx512": same bits; not recorded
    std::map<std::string, double> settings;  ///< "phaco.power_limit" = 0.6, ...; names and ranges: session/settings.hpp
    SceneAccuracy accuracy;  ///< how patient.tetrahedra, step_s, advance and meshes in settings were chosen
};

}  // namespace rhexis
