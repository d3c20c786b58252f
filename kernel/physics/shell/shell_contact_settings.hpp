// SPDX-License-Identifier: GPL-3.0-or-later
// How a shell's contacts are solved. The defaults are those of the chart in docs/implant.md, "In the bag".
#pragma once

#include <optional>

namespace rhexis {

struct ShellContactSettings {
    double stiffer = 20.0;         ///< the springs than the shell across its thickness,
    double stiffer_sheet = 200.0;  ///< but at most so much than a membrane that it meets
    double onset = 0.1;            ///< penetration over which the springs gain their stiffness, of the thickness
    double stick = 0.006;          ///< stiffness of what sticks over that
    std::optional<int> level{};    ///< of sampling; none: by the size of the partner
    bool turns = true;             ///< contact turns nodes, else it only moves them
    bool accounts = false;         ///< where energy goes is found in full, for tests and measurements
};

}  // namespace rhexis
