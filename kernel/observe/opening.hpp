// SPDX-License-Identifier: GPL-3.0-or-later
// The edge of what was torn open in a sheet: found among the sheet's boundaries and unfolded, because the two sides of
// a tear lie on each other at rest.
#pragma once

#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

struct TornOpening {
    bool exists = false;
    bool closed = false;      ///< its edge goes round a piece that came loose, of more than 2 mm^2
    bool run_out = false;     ///< some tear of the sheet has reached its outer edge
    double torn = 0.0;        ///< length of all tears of the sheet at rest [mm]
    double loose = 0.0;       ///< area at rest of what has come off what hangs at the outer edge [mm^2]
    int tip = -1;             ///< the leading one, index into the state's tips; -1: none is left at this opening
    std::vector<int> lip;     ///< nodes of the flap's edge, from the leading tip on for 2 mm; empty without a tip
    std::vector<int> margin;  ///< likewise of the other edge of the tear, that of what stays
    std::vector<int> rim;     ///< closed: nodes once round the rim, without side slits; else empty
    std::vector<Vec3> edge;   ///< all its nodes at rest, both sides of slits [mm]
    std::vector<Vec3> curve;  ///< closed: once round the rim; else along the tear, end to end. Without side slits [mm]
};

/// The opening with the longest edge. Pieces that came loose do not count: only what still hangs at the sheet's outer
/// edge has openings. The outer edge is the longest boundary of `start`, the sheet before anything was torn; holes that
/// it has already are openings. Where a tear ran out to the outer edge, the stretch of the boundary that follows the
/// tear is taken; where one went from edge to edge, that is a curve that is not closed. The leading tip is the one of
/// the opening's that went on last, that is the last of them in the state's list. Work: in proportion to the sheet's
/// triangles. The result changes only when state.sheet does.
TornOpening find_opening(const MembraneSheet& start, const MembraneState& state);

}  // namespace rhexis
