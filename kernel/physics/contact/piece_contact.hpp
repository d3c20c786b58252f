// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: pieces of one body against each other. A surface vertex meets the plane of the surface triangle of
// another piece that faces it and is nearest; found once per step, with a plane and a foot that stay for the step.
#pragma once

#include <vector>

#include "flow/solid.hpp"
#include "physics/contact/contact_point.hpp"
#include "physics/contact/contact_surface.hpp"

namespace rhexis {

/// A vertex of the surface before a triangle of another piece.
struct PiecePair {
    ContactPoint vertex;
    ContactPoint foot;            ///< the nearest place of the triangle
    Vec3 normal = Vec3::UnitZ();  ///< unit, of the triangle, outward from its piece
};

/// Pairs of all pieces with all others, by vertex; none while the body is in one piece.
void find_piece_pairs(const ContactSurface& surface, const std::vector<Vec3>& nodes, std::vector<PiecePair>& pairs);

/// Coulomb coefficient of lens tissue against itself. Proposal.
inline constexpr double piece_friction = 0.2;

}  // namespace rhexis
