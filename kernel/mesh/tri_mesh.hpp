// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle meshes of open sheets: what they are made of, who is beside whom, and whether they are fit for mechanics.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis {

/// A sheet at rest. All triangles are seen counter-clockwise from its front.
struct TriMesh {
    std::vector<Vec3> nodes;                    ///< [mm]
    std::vector<std::array<int, 3>> triangles;  ///< node indices
};

/// Local edge k of a triangle is opposite its local node k and runs from node k + 1 to node k + 2.
struct TriNeighbours {
    std::vector<std::array<int, 3>> across;  ///< per triangle and edge: the triangle there, or -1
    std::vector<int> offset;                 ///< node count + 1
    std::vector<int> triangles;              ///< around each node, ascending: offset[n] .. offset[n + 1] - 1
};
TriNeighbours tri_neighbours(const TriMesh& mesh);
/// The same of a mesh that came from another one. changed: triangles with other corners than there, and all new ones.
TriNeighbours tri_neighbours(const TriMesh& mesh, const TriNeighbours& before, std::span<const int> changed);

/// Whether any edge at the node has a triangle on one side only.
std::vector<std::uint8_t> on_boundary(const TriMesh& mesh, const TriNeighbours& neighbours);

Vec3 triangle_middle(const TriMesh& mesh, int triangle);  ///< [mm]
/// The triangle whose middle is nearest to a place.
int nearest_triangle(const TriMesh& mesh, const Vec3& place);
double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);  ///< [mm^2]
double mesh_area(const TriMesh& mesh);                              ///< [mm^2]

/// Cosine of the smallest angle.
double largest_cosine(const Vec3& a, const Vec3& b, const Vec3& c);
/// Smallest angle [rad]; for people, not for decisions: it depends on the C library.
double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c);
double smallest_angle(const TriMesh& mesh);

/// Mean length of the edges [mm].
double mean_edge(const TriMesh& mesh);

/// Nodes that belong to no triangle.
enum class UnusedNodes {
    refused,
    allowed,  ///< what was taken out of a sheet leaves them
};

/// Every node finite and used, every triangle with three different nodes that exist and an area, no edge shared by more
/// than two triangles or run twice the same way (a flipped triangle), no node at which two sheets only touch. Otherwise
/// the first fault with its number, from 0. where: for the message.
Status validate_tri_mesh(const TriMesh& mesh, const std::string& where = {}, UnusedNodes unused = UnusedNodes::refused);

/// Closed loops of boundary nodes, each along the sheet's edge with the sheet on the left, starting at its smallest
/// node; the loops by that node. The mesh must be valid.
std::vector<std::vector<int>> boundary_loops(const TriMesh& mesh, const TriNeighbours& neighbours);

/// Per triangle: the number of its connected part, from 0 in the order of their first triangles.
std::vector<int> sheet_parts(const TriNeighbours& neighbours);

}  // namespace rhexis
