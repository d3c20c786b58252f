// SPDX-License-Identifier: GPL-3.0-or-later
// observe -> curriculum, recorder: named measures. The schema is fixed when the scene is built; each step is one row.
#pragma once

#include <string>
#include <vector>

namespace rhexis {

/// What one number of an observation means. In Lua, "phaco.tip_depth_mm" is eye.phaco.tip_depth_mm.
struct MeasureInfo {
    std::string name;     ///< "group.name_unit"
    std::string unit;     ///< "mm", "mN", "1", ...; "bool" shows as true/false in Lua
    std::string meaning;  ///< one plain sentence
};

using ObservationSchema = std::vector<MeasureInfo>;

struct Observation {
    double time_s = 0.0;
    std::vector<double> values;  ///< one per schema entry; NaN: not defined now (shows as nil in Lua)
};

}  // namespace rhexis
