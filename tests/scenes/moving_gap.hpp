// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two parts of surfaces stay apart while their corners move evenly through a step: a proof or none, never a
// miss. What lies between a corner and a triangle, or between two edges, is linear in time and in each of two places
// along them, so over any cell of the three it stays within the hull of the values at the cell's eight corners: where
// all of these lie beyond what is allowed along some one direction, the cell is free. Cells that are not told so are
// halved until they are as small as the resolution [Wang2021]. Thickness is part of the proof: what is allowed is
// linear over a cell, too.
#pragma once

#include <array>

#include "math/types.hpp"

namespace rhexis::scenes {

/// A corner of a surface in a step.
struct Mover {
    Vec3 from = Vec3::Zero();  ///< at its start [mm]
    Vec3 to = Vec3::Zero();    ///< at its end [mm]
    double half = 0.0;         ///< thickness on either side [mm]
};

/// At a corner of the cube of the three parameters.
struct GapCorner {
    Vec3 way = Vec3::Zero();  ///< from one place to the other [mm]
    double reach = 0.0;       ///< the distance that they must keep [mm]
};

/// Linear in each of three parameters from 0 to 1. Corner i is at (i & 1, i >> 1 & 1, i >> 2 & 1); the first is time,
/// or the place along an edge in what does not move.
using GapCube = std::array<GapCorner, 8>;

/// depth: allowed, as a share of the thickness: the mean of both, or that of the only one that has any.
GapCube corner_to_triangle(const Mover& corner, const std::array<Mover, 3>& triangle, double depth);
GapCube edge_to_edge(const std::array<Mover, 2>& a, const std::array<Mover, 2>& b, double depth);
/// At the start of the step: from an edge to a triangle, without thickness.
GapCube edge_to_triangle(const std::array<Mover, 2>& edge, const std::array<Mover, 3>& triangle);

struct Verdict {
    bool apart = true;
    double since = 1.0;  ///< if not: the first parameter's value near one place where that could not be proven
};

/// Apart: proven for every value of the parameters, rounding included. Else somewhere they are not farther apart than
/// their reach by more than about `resolution` [mm, above 0], or it took too many cells to tell.
Verdict stays_apart(const GapCube& cube, double resolution);

/// Least distance of two places at the end of the step [mm].
double end_distance(const Mover& corner, const std::array<Mover, 3>& triangle);
double end_distance(const std::array<Mover, 2>& a, const std::array<Mover, 2>& b);

/// Whether four corners end on the other side of one another than they began: of a corner and a triangle, or two edges.
bool changed_sides(const std::array<Mover, 4>& corners);

}  // namespace rhexis::scenes
