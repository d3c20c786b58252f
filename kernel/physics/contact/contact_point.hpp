// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a point of a solid that can touch something, moving with up to four of its coarse nodes.
#pragma once

#include <array>
#include <vector>

#include "math/types.hpp"
#include "physics/contact/contact_surface.hpp"

namespace rhexis {

/// A vertex of the surface, or a material point within a tetrahedron (mesh/material_points.hpp).
struct ContactPoint {
    int id = 0;  ///< in its body, from step to step: of vertices first, then four for each fine tetrahedron
    std::array<int, 4> nodes{0, 0, 0, 0};               ///< a vertex that is a node has it twice
    std::array<double, 4> weights{0.5, 0.5, 0.0, 0.0};  ///< descending; a node of weight 0 does not count
    double stiffness = 0.0;  ///< what the tissue around it offers to a push: Young's modulus x size [uN/mm]
    double size = 0.0;       ///< distance to the points beside it [mm]
    double radius = 0.0;     ///< how far tissue reaches around it [mm]
};

inline ContactPoint contact_point(const SurfaceVertex& vertex) {
    const int first = vertex.nodes[0];
    const int second = vertex.nodes[1] < 0 ? first : vertex.nodes[1];
    return {vertex.vertex, {first, second, first, first}, {0.5, 0.5, 0.0, 0.0}, vertex.stiffness, vertex.size, 0.0};
}

inline bool is_node(const ContactPoint& point) { return point.nodes[0] == point.nodes[1]; }

/// As contacts name them: the first three that bear anything, -1 for the rest.
inline void bearing_nodes(const ContactPoint& point, std::array<int, 3>& nodes, std::array<double, 3>& weights) {
    nodes = {-1, -1, -1};
    weights = {0.0, 0.0, 0.0};
    if (is_node(point)) {
        nodes[0] = point.nodes[0];
        weights[0] = 1.0;
        return;
    }
    for (std::size_t k = 0; k < 3 && point.weights[k] > 0.0; ++k) {
        nodes[k] = point.nodes[k];
        weights[k] = point.weights[k];
    }
}

inline Vec3 point_of(const ContactPoint& point, const std::vector<Vec3>& nodes) {
    Vec3 sum = point.weights[0] * nodes[static_cast<std::size_t>(point.nodes[0])];
    for (std::size_t k = 1; k < 4; ++k) {
        sum += point.weights[k] * nodes[static_cast<std::size_t>(point.nodes[k])];
    }
    return sum;
}

}  // namespace rhexis
