// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of elements: found as a value, applied once, validated.
#pragma once

#include "base/result.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Fine tetrahedra whose fraction reached 0 between two states of one solid, and the coarse ones that go with them: a
/// coarse tetrahedron goes when its 8 children are gone.
MeshEdit spent_elements(const SolidState& before, const SolidState& after, int solid);

/// The same without a state to compare with: every fine tetrahedron at fraction 0 whose coarse one is still present.
MeshEdit spent_elements(const SolidModel& model, const SolidState& state, int solid);

/// Removes named coarse tetrahedra with their children, whatever is left of them. Those already gone are left out.
MeshEdit remove_coarse(const SolidModel& model, const SolidState& state, int solid, const std::vector<int>& tets);

/// Mass that an edit takes away: what is still left of the elements it removes [g].
double edit_mass(const MeshEdit& edit, const SolidModel& model, const SolidState& state);

/// Applies an edit to the state it was made from: fractions to 0, masks cleared, nodes without elements stopped.
void apply(const MeshEdit& edit, const SolidModel& model, SolidState& state);

/// Masks, fractions and sizes consistent, every number finite; names the first element that is not.
Status validate(const SolidModel& model, const SolidState& state);

}  // namespace rhexis
