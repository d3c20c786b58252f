// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of elements: found as a value, applied once, validated.
#pragma once

#include "base/result.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Fine tetrahedra whose fraction reached 0 since they were last looked at, and the coarse ones that go with them: a
/// coarse tetrahedron goes when its 8 children are gone.
MeshEdit spent_elements(const SolidModel& model, const SolidState& state, int solid);

/// Removes named coarse tetrahedra with their children, whatever is left of them.
MeshEdit remove_coarse(const SolidModel& model, const SolidState& state, int solid, const std::vector<int>& tets);

/// Applies an edit to the state it was made from: fractions to 0, masks cleared, nodes without elements stopped.
void apply(const MeshEdit& edit, const SolidModel& model, SolidState& state);

/// Masks, fractions and sizes consistent, every number finite; names the first element that is not.
Status validate(const SolidModel& model, const SolidState& state);

}  // namespace rhexis
