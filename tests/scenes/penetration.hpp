// SPDX-License-Identifier: GPL-3.0-or-later
// Verifies committed steps: that surfaces of triangles whose corners move evenly from one state to the next went
// through nothing, themselves included, and how deep they lie in it. A step is free to a depth when every corner
// against every triangle and every edge against every edge is proven so (moving_gap.hpp), and every triangle against
// what is rigid, by balls about parts of it whose distance is more than their radius. Neighbours along a surface have
// no thickness against each other, and what has a corner in common does not meet.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "flow/membrane.hpp"
#include "flow/shell.hpp"
#include "scenes/moving_gap.hpp"

namespace rhexis::scenes {

/// A surface that is verified: what of it does not change in a step.
struct Skin {
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> half;  ///< per corner: thickness on either side [mm]; all zero: it has none
    std::vector<int> place;    ///< per corner: corners of one number are one place
    // neighbours along the surface
    std::vector<std::array<int, 3>> nodes;  ///< per corner: of the mesh, by which it lies; -1: unused
    std::vector<int> parent;                ///< per triangle: a row of `near`
    std::vector<std::vector<int>> near;     ///< nodes, ascending, that are too near to be another layer
};

/// A shell as its layers touch each other: every triangle cut in 4^level on the curved middle surface; neighbours as
/// those that its contact leaves out: nearer than one and a half times the thickness along edges.
Skin shell_skin(const ShellModel& model, int level = 1);
std::vector<Vec3> skin_places(const ShellModel& model, const ShellState& state, int level = 1);

/// A sheet. Copies of a node that a tear made are one place. layer_distance: that its layers
/// keep, or 0 [mm].
Skin sheet_skin(const MembraneSheet& sheet, double layer_distance = 0.0);

/// In a step.
struct MovingSkin {
    const Skin& skin;
    std::span<const Vec3> from;  ///< per corner [mm]
    std::span<const Vec3> to;
};

/// Something rigid that moves.
struct MovingSolid {
    /// Of a place from its surface at a share of the step; changes by no more than the place moves [mm].
    std::function<double(double share, const Vec3& place)> distance;
    double travel = 0.0;  ///< of its surface in the step, at most, by any share no more than that [mm]
};

/// Depths that are tried, as shares of the thickness (the mean of both, or that of the only one that has any),
/// ascending; the last is 1: surfaces do not cross.
inline const std::vector<double> depths_tried{0.0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

struct StepFinding {
    /// Of depths_tried: the least to which the step is proven free; depths_tried.size(): not proven to cross nothing.
    std::size_t level = 0;
    int crossing = 0;      ///< pairs that may have crossed
    double since = 1.0;    ///< share of the step at which one of these may have
    double deepest = 0.0;  ///< of pairs not proven free of any depth, at the end; of what crossed: beyond that [mm]
    double of_thickness = 0.0;
    double of_edge = 0.0;  ///< over the mean edge of the surface at the end
    long pairs = 0;        ///< that came near enough to be looked at

    void add(const StepFinding& other);
};

StepFinding verify_itself(const MovingSkin& skin);
StepFinding verify_pair(const MovingSkin& a, const MovingSkin& b);
/// Depths under a tenth of the thickness are not told apart.
StepFinding verify_solid(const MovingSkin& skin, const MovingSolid& solid);

/// Edges that go through triangles, or may, where the surface stands at the start of the step: 0 proves that it does
/// not lie in itself. Of two surfaces: through each other.
int pierced_at_start(const MovingSkin& skin);
int pierced_at_start(const MovingSkin& a, const MovingSkin& b);

}  // namespace rhexis::scenes
