// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth without sorting. With density constant in each tetrahedron, the integral along a ray is a sum over
// faces: distance to the face times the change of density across it, added where the ray leaves and subtracted where it
// enters. Faces between equal densities drop out, so that an untouched lens costs its outer and inner borders only.
#pragma once

#include <array>
#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

/// Seen from the outside of the tissue that it was made for, the corners turn counter-clockwise.
struct SignedFace {
    std::array<Vec3, 3> corners;  ///< [mm]
    Eigen::Vector3f change;       ///< extinction behind the face less that before it [1/mm]
};
using FaceStream = std::vector<SignedFace>;

/// Appends the faces of one solid across which its extinction changes. `fine` is scratch.
void append_signed_faces(const SolidModel& model, const SolidState& state, std::vector<Vec3>& fine, FaceStream& stream);

/// Extinction of each coarse tetrahedron of a solid while whole [1/mm].
std::vector<Vec3> coarse_extinction(const SolidModel& model);

}  // namespace rhexis
