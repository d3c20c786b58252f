// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of a solid between two tools, and of one that is cut under a tool. Each returns what it measured; the
// gates stand where it is called.
#pragma once

#include "flow/solid.hpp"
#include "scenes/shell_trials.hpp"

namespace rhexis::scenes {

/// T12: two balls of 1 mm come from above and below into a free cube of 2 mm, each by `depth` [mm], and stand still.
Squeeze squeeze_cube(Advance way, double depth, bool quick);

struct CutPress {
    double apart = 0.0;    ///< largest distance of a node from where it is with new factors, over its largest shift
    double deepest = 0.0;  ///< penetration over the edge of the mesh
    int failures = 0;      ///< steps that no way could solve
};
/// T15: a ball pressed into a block, implicitly; tetrahedra beside it go, a few before each of so many steps.
CutPress cut_under_tool(int steps);

}  // namespace rhexis::scenes
