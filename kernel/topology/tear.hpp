// SPDX-License-Identifier: GPL-3.0-or-later
// Tears of a membrane, by one edge at a time: where there is no edge in the wanted direction, one is made by splitting
// the triangles that it crosses [OBrien2002], unless that leaves slivers; then the nearest edge is taken. What an edge
// leads astray is owed to the tip and made good by the next ones, so that a path does not stick to the lines of a mesh.
// Splitting changes neither shape nor energy; opening an edge copies nodes where they are.
//
// However often a sheet is torn, it stays a mesh fit for mechanics, of bounded size: triangles that a split leaves have
// no angle under 15 degrees and no edge under l, a tenth of the mean edge at the start, hence an area of l^2 / 4 at
// least; the others are as they were at the start. Of a sheet of T triangles and area A there are never more than T + 4
// A / l^2, and at most three nodes per triangle.
#pragma once

#include "base/result.hpp"
#include "flow/membrane_edit.hpp"
#include "flow/step_outcome.hpp"

namespace rhexis {

struct TearRules {
    bool existing_edges = false;     ///< only along edges that are there
    double snap_tangent = 0.1;       ///< of the angle of the wanted direction from an edge that is taken instead
    double snap_share = 0.2;         ///< of the length of the opposite edge, from its ends
    double most_cosine = 0.9659258;  ///< of an angle that a split may leave: 15 degrees
    double shortest_edge = 0.1;      ///< that a split may leave, share of the mean edge of the model's sheet
};

/// The tear goes on from a tip. direction: in the sheet at rest, need not be unit. Fails on a tip that does not exist
/// and on a direction that is zero, not finite, or leads out of the sheet.
Result<MembraneEdit> tear(const MembraneModel& model, const MembraneState& state, int tip, const Vec3& direction,
                          const TearRules& rules = {});

/// A slit of two edges along a direction and against it, from the node of the triangle that is nearest to a place at
/// rest, or from one that is put on an edge of it where that comes nearer and leaves no slivers; both its ends are
/// tips. Fails where the place is not on the triangle (farther from its middle than its longest edge), where that node
/// is on an edge of the sheet, and as tear() does.
Result<MembraneEdit> puncture(const MembraneModel& model, const MembraneState& state, int triangle, const Vec3& place,
                              const Vec3& direction, const TearRules& rules = {});

/// A tear that begins at a node on an edge of the sheet, likewise.
Result<MembraneEdit> notch(const MembraneModel& model, const MembraneState& state, int node, const Vec3& direction,
                           const TearRules& rules = {});

/// The state with the edit made. Positions and velocities of new nodes follow from those that they lie between.
MembraneState applied(const MembraneState& state, const MembraneEdit& edit);

/// Takes out the pieces of the sheet that some nodes are of, if they hang at nothing: no node of theirs is one of the
/// model's springs or fixed nodes, and they are not the largest piece. No edit where there are none.
MembraneEdit take_out(const MembraneModel& model, const MembraneState& state, const std::vector<int>& nodes);

/// Carries out what physics proposes, one edge per tip and one slit per needle, and notches only where no tear goes on;
/// what cannot be done in the mesh is left out. What jaws held that have left the eye goes with them. Returns how much
/// was done.
int carry_out(const MembraneModel& model, const MembraneStepReport& report, MembraneState& state,
              const TearRules& rules = {});

}  // namespace rhexis
