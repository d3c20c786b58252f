// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the points of a solid that can touch something, kept up to date while tetrahedra vanish.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

/// A vertex of the fine mesh: a coarse node, or the middle of two. Without a fine mesh, a coarse node.
struct SurfaceVertex {
    int vertex = 0;                   ///< fine (or coarse) node
    std::array<int, 2> nodes{0, -1};  ///< coarse nodes; the second -1: the vertex is the first
    double weight = 1.0;              ///< of each of the nodes: 1 or 1/2
    double stiffness = 0.0;           ///< what the tissue around it offers to a push: Young's modulus x size [uN/mm]
    bool between = false;             ///< the middle of two nodes that are on the boundary themselves
    double size = 0.0;                ///< edge length of the tetrahedra around it [mm]
    int piece = 0;                    ///< the piece of the body that it belongs to: its lowest coarse tetrahedron
};

Vec3 point_of(const SurfaceVertex& vertex, const std::vector<Vec3>& nodes);

class ContactSurface {
public:
    explicit ContactSurface(const SolidModel& model);

    /// Finds the boundary of what is present, if that changed since the last call.
    void update(const SolidModel& model, const SolidState& state);

    /// Vertices on the current boundary, ascending.
    [[nodiscard]] const std::vector<SurfaceVertex>& vertices() const { return vertices_; }

    /// How far the material points of each coarse tetrahedron lie apart at rest [mm].
    [[nodiscard]] const std::vector<double>& point_spacings() const { return point_spacings_; }

    /// Triangles of the current boundary, by place in vertices(), seen from outside.
    [[nodiscard]] const std::vector<std::array<int, 3>>& faces() const { return faces_; }

    /// Whether the body is in more pieces than one.
    [[nodiscard]] bool in_pieces() const { return in_pieces_; }

    /// Outward unit normals of the vertices where the nodes are now; zero where the faces around one cancel out.
    void normals(const std::vector<Vec3>& nodes, std::vector<Vec3>& normals) const;

private:
    void rebuild(const SolidModel& model);
    void find_pieces(const SolidModel& model);

    std::vector<SurfaceVertex> all_;  ///< every vertex of the mesh, on the boundary or not
    std::vector<std::array<int, 4>> coarse_neighbours_;
    std::vector<double> point_spacings_;
    std::vector<std::uint8_t> alive_;  ///< per (fine) tetrahedron, at the last update
    std::vector<std::uint8_t> outer_;  ///< scratch: per vertex
    std::vector<SurfaceVertex> vertices_;
    std::vector<std::array<int, 3>> faces_;
    bool in_pieces_ = false;
    bool built_ = false;
};

}  // namespace rhexis
