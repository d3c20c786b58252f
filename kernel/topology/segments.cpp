// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/segments.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/adjacency.hpp"
#include "mesh/places.hpp"
#include "topology/remove.hpp"

namespace rhexis {

namespace {

/// Normals of the cutting planes, by roots: the same bits on every machine.
std::vector<Vec2> cuts(int segments) {
    const double half_root3 = 0.5 * std::sqrt(3.0);
    const double half_root2 = 0.5 * std::sqrt(2.0);
    switch (segments) {
        case 2:
            return {{1, 0}};
        case 4:
            return {{1, 0}, {0, 1}};
        case 6:
            return {{1, 0}, {0.5, half_root3}, {-0.5, half_root3}};
        case 8:
            return {{1, 0}, {half_root2, half_root2}, {0, 1}, {-half_root2, half_root2}};
        default:
            return {};
    }
}

/// On which side of each plane a tetrahedron lies, as bits.
unsigned sides(const TetMesh& mesh, int tet, const std::vector<Vec2>& normals) {
    Vec2 sum = Vec2::Zero();
    for (const int node : mesh.tets[tet]) {
        sum += mesh.nodes[node].head<2>();
    }
    unsigned bits = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        bits |= normals[i].dot(sum) > 0.0 ? 1U << i : 0U;
    }
    return bits;
}

constexpr double trench_reach = 0.75;  ///< of the equator's radius

}  // namespace

std::vector<BrokenFace> segment_faces(const SolidModel& model, int segments) {
    const std::vector<Vec2> normals = cuts(segments);
    std::vector<BrokenFace> faces;
    if (normals.empty()) {
        return faces;
    }
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(model.coarse.tets);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (const int other : neighbours[t]) {
            if (other > t && sides(model.coarse, t, normals) != sides(model.coarse, other, normals)) {
                faces.push_back({t, other});
            }
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

MeshEdit trench(const SolidModel& model, const SolidState& state, int solid, int segments, double width) {
    const std::vector<Vec2> normals = cuts(segments);
    double equator = 0.0;
    for (const Vec3& node : model.coarse.nodes) {
        equator = std::max(equator, node.head<2>().norm());
    }
    SolidState after = state;
    for (int t = 0; t < static_cast<int>(model.fine.tets.size()); ++t) {
        const Vec3 middle = fine_middle(model.fine, model.coarse.nodes, t);
        const Vec2 across = middle.head<2>();
        const bool near = std::any_of(normals.begin(), normals.end(),
                                      [&](const Vec2& normal) { return std::abs(normal.dot(across)) < 0.5 * width; });
        const bool above = middle.z() > 0.0 || model.coarse.region[t / 8] == 0;
        if (near && above && across.norm() < trench_reach * equator) {
            after.fraction[t] = 0.0;
        }
    }
    return spent_elements(state, after, solid);
}

}  // namespace rhexis
