// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces come apart: where nothing but nodes still joins two pieces of a body, or faces are broken, nodes are split.
//
// Two neighbouring tetrahedra hold together while a pair of fine ones on either side of their common face is left and
// the face is not broken. A node is split where its tetrahedra fall into groups that no such pair joins: between pieces
// that hold together nowhere else, and along broken faces.
#pragma once

#include <vector>

#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Per coarse tetrahedron the lowest one of its piece; -1: not present.
std::vector<int> pieces_of(const SolidModel& model, const SolidState& state);

/// The splits that follow from a state and from faces that break in it (`broken`, each pair ascending). Faces that
/// broke before are in the state.
MeshEdit come_apart(const SolidModel& model, const SolidState& state, int solid, const std::vector<BrokenFace>& broken);

/// The model with more nodes: the base with these splits made in turn. Rest positions are copied, faces open.
SolidModel split_model(const SolidModel& base, const std::vector<NodeSplit>& splits);

/// Whether these splits can be made in a mesh: nodes and tetrahedra that exist and belong together.
bool splits_fit(const SolidModel& base, const std::vector<NodeSplit>& splits);

/// Gives new nodes the position and velocity of those that they came from, and notes breaks and splits.
void apply_splits(const MeshEdit& edit, SolidState& state);

}  // namespace rhexis
