// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of simple solids and sheets, made by our own deterministic generators.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/half_ellipsoids.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

/// A block of nx * ny * nz cubic cells of edge `cell` [mm] with one corner at `origin`. Each cell is cut into 5
/// tetrahedra, mirrored between cells of even and odd i + j + k so that the diagonals of neighbours meet. Counts >= 1.
/// Node (i, j, k) has index i + (nx + 1) * (j + (ny + 1) * k).
TetMesh bar(int nx, int ny, int nz, double cell, const Vec3& origin = Vec3::Zero());

/// Nodes with |(x - point) . normal| <= tolerance, ascending. normal: unit.
std::vector<int> nodes_on_plane(const TetMesh& mesh, const Vec3& point, const Vec3& normal, double tolerance = 1e-9);

/// A solid between two half-ellipsoids that share their equator, of `tetrahedra` elements (within about 3 %).
/// tetrahedra: 300 to 100,000. Surface nodes lie on the shape; every tetrahedron is positively oriented.
TetMesh lens_body(const HalfEllipsoids& shape, int tetrahedra);

/// A ball about the origin. radius [mm] > 0; tetrahedra: 300 to 100,000.
TetMesh ball(double radius, int tetrahedra);

/// A square sheet in the plane z = 0 with one corner at the origin and its front towards +z: rows of nodes, every other
/// one shifted by half an edge. side [mm] > 0; triangles: 8 to 100,000, met within a row.
TriMesh square_sheet(double side, int triangles);

/// A round sheet about the origin, likewise: rings of 6, 12, 18, ... nodes. radius [mm] > 0; triangles: 6 to 100,000.
TriMesh round_sheet(double radius, int triangles);

/// Moves the nodes of a flat sheet that are not on its boundary at random, in the plane, by up to `share` of the mean
/// edge (0 to 0.3). seed: chooses the movement.
TriMesh jittered(TriMesh sheet, double share, std::uint64_t seed);

}  // namespace rhexis
