// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that the lens is in.
#pragma once

#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

struct LensPiece {
    int first = 0;               ///< its lowest coarse tetrahedron: its name while it holds together
    double volume = 0.0;         ///< what is left of it, at rest [mm^3]
    Vec3 centre = Vec3::Zero();  ///< of what is left [mm]
    double lowest = 0.0;         ///< least z of its nodes [mm]
    double highest = 0.0;        ///< greatest z [mm]
};

/// Ascending by name. volumes: of whole coarse tetrahedra at rest.
std::vector<LensPiece> lens_pieces(const SolidModel& lens, const std::vector<double>& volumes, const SolidState& state);

/// Per piece the middle of its tissue that is nearest to a place: of a fine tetrahedron of which at least a third is
/// left; the piece's own middle if it has none.
std::vector<Vec3> nearest_tissue(const SolidModel& lens, const SolidState& state, const std::vector<LensPiece>& pieces,
                                 const Vec3& place);

}  // namespace rhexis
