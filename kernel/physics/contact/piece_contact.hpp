// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: pieces of one body against each other. A surface vertex meets the plane of the nearest vertex of
// another piece that faces it; found once per step, with a plane that stays for the step.
#pragma once

#include <vector>

#include "flow/solid.hpp"
#include "physics/contact/contact_surface.hpp"

namespace rhexis {

/// Two surface vertices of different pieces.
struct PiecePair {
    int vertex = 0;               ///< index into the surface's vertices
    int other = 0;                ///< whose plane it is
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward from the other's piece
};

/// Pairs that can meet while nothing moves by more than `moved` [mm]; none while the body is in one piece.
void find_piece_pairs(const ContactSurface& surface, const std::vector<Vec3>& nodes, double moved,
                      std::vector<PiecePair>& pairs);

/// Coulomb coefficient of lens tissue against itself. Proposal.
inline constexpr double piece_friction = 0.2;

}  // namespace rhexis
