// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces too small for their shape to matter become rigid debris.
#pragma once

#include <vector>

#include "flow/debris.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// What leaves the mesh, and as what it goes on: the debris has the volume and mass of what was left of its piece.
struct Crumbs {
    MeshEdit edit;
    std::vector<Debris> debris;
};

/// All pieces of less than `below` [mm^3]. pieces: of pieces_of().
Crumbs crumble(const SolidModel& model, const SolidState& state, int solid, const std::vector<int>& pieces,
               double below);

/// Volume below which a piece is debris [mm^3]: about that of a tetrahedron of the lens, a ball as wide as the bore.
inline constexpr double debris_volume = 0.2;

}  // namespace rhexis
