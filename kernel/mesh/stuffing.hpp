// SPDX-License-Identifier: GPL-3.0-or-later
// Inside mesh: fills a smooth solid with tetrahedra of a body-centred cubic lattice.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/half_ellipsoids.hpp"
#include "mesh/tet_mesh.hpp"

namespace rhexis {

struct StuffedSolid {
    TetMesh mesh;                          ///< positively oriented; region 0
    std::vector<std::uint8_t> on_surface;  ///< per node: 1 if it lies on the shape
};

/// Isosurface stuffing [Labelle2007]: lattice points close to the surface snap onto it, tetrahedra that still straddle
/// it are cut, so that every element is well shaped and every surface node lies on the surface.
/// spacing: edge of a lattice cube [mm] > 0; offset: where a lattice point lies, in units of the spacing.
StuffedSolid stuff(const HalfEllipsoids& shape, double spacing, const Vec3& offset);

}  // namespace rhexis
