// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/contact_surface.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/adjacency.hpp"
#include "mesh/components.hpp"

namespace rhexis {

namespace {

/// Per coarse node: the stiffest tissue around it and the size of its tetrahedra.
struct NodeTissue {
    double modulus = 0.0;
    double edge_squares = 0.0;
    int edges = 0;

    [[nodiscard]] double size() const { return std::sqrt(edge_squares / std::max(1, edges)); }
};

std::vector<NodeTissue> node_tissue(const SolidModel& model) {
    std::vector<NodeTissue> tissue(model.coarse.nodes.size());
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const double modulus = model.materials[model.coarse.region[t]].young_modulus;
        for (int node : tet) {
            tissue[node].modulus = std::max(tissue[node].modulus, modulus);
            for (int other : tet) {
                tissue[node].edge_squares += (model.coarse.nodes[node] - model.coarse.nodes[other]).squaredNorm();
            }
            tissue[node].edges += 3;
        }
    }
    return tissue;
}

std::vector<double> spacings_of_points(const SolidModel& model) {
    constexpr double points_each = 32.0;
    std::vector<double> spacings;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        const double density = model.materials[model.coarse.region[t]].density;
        spacings.push_back(std::cbrt(tet_mass(model, static_cast<int>(t)) / (points_each * density)));
    }
    return spacings;
}

SurfaceVertex make_vertex(int vertex, int a, int b, const std::vector<NodeTissue>& tissue) {
    SurfaceVertex made;
    made.vertex = vertex;
    made.nodes = {a, b};
    made.weight = b < 0 ? 1.0 : 0.5;
    const NodeTissue& other = tissue[b < 0 ? a : b];
    made.size = 0.5 * (tissue[a].size() + other.size());
    made.stiffness = std::max(tissue[a].modulus, other.modulus) * made.size;
    return made;
}

}  // namespace

Vec3 point_of(const SurfaceVertex& vertex, const std::vector<Vec3>& nodes) {
    return vertex.nodes[1] < 0 ? nodes[vertex.nodes[0]] : Vec3(0.5 * (nodes[vertex.nodes[0]] + nodes[vertex.nodes[1]]));
}

ContactSurface::ContactSurface(const SolidModel& model) : point_spacings_(spacings_of_points(model)) {
    const std::vector<NodeTissue> tissue = node_tissue(model);
    const int nodes = static_cast<int>(model.coarse.nodes.size());
    for (int node = 0; node < nodes; ++node) {
        all_.push_back(make_vertex(node, node, -1, tissue));
    }
    if (model.fine.tets.empty()) {
        coarse_neighbours_ = face_neighbours(model.coarse.tets);
    } else {
        for (const std::array<int, 2>& edge : model.fine.edges) {
            all_.push_back(make_vertex(static_cast<int>(all_.size()), edge[0], edge[1], tissue));
        }
    }
    alive_.assign(model.fine.tets.empty() ? model.coarse.tets.size() : model.fine.tets.size(), 0);
}

void ContactSurface::update(const SolidModel& model, const SolidState& state) {
    const bool fine = !model.fine.tets.empty();
    bool changed = !built_;
    for (std::size_t t = 0; t < alive_.size(); ++t) {
        const bool alive = fine ? state.fraction[t] > 0.0 && state.present[t / 8] != 0 : state.present[t] != 0;
        changed = changed || alive != (alive_[t] != 0);
        alive_[t] = alive ? 1 : 0;
    }
    if (changed) {
        rebuild(model);
        built_ = true;
    }
}

void ContactSurface::rebuild(const SolidModel& model) {
    const bool fine = !model.fine.tets.empty();
    const std::vector<std::array<int, 4>>& tets = fine ? model.fine.tets : model.coarse.tets;
    const std::vector<std::array<int, 4>>& neighbours = fine ? model.fine.neighbours : coarse_neighbours_;
    outer_.assign(all_.size(), 0);
    faces_.clear();
    for (std::size_t t = 0; t < tets.size(); ++t) {
        if (alive_[t] == 0) {
            continue;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const int other = neighbours[t][k];
            if (other < 0 || alive_[other] == 0) {
                const std::array<int, 3>& face = tet_faces[k];
                faces_.push_back({tets[t][face[0]], tets[t][face[1]], tets[t][face[2]]});
                for (int corner : faces_.back()) {
                    outer_[corner] = 1;
                }
            }
        }
    }
    vertices_.clear();
    std::vector<int> place(all_.size(), -1);
    for (std::size_t v = 0; v < all_.size(); ++v) {
        if (outer_[v] != 0) {
            const std::array<int, 2>& nodes = all_[v].nodes;
            place[v] = static_cast<int>(vertices_.size());
            vertices_.push_back(all_[v]);
            vertices_.back().between = nodes[1] >= 0 && outer_[nodes[0]] != 0 && outer_[nodes[1]] != 0;
        }
    }
    for (std::array<int, 3>& face : faces_) {
        face = {place[face[0]], place[face[1]], place[face[2]]};
    }
    find_pieces(model);
}

/// What shares a node hangs together: topology splits the nodes of what does not.
void ContactSurface::find_pieces(const SolidModel& model) {
    const std::size_t coarse = model.coarse.tets.size();
    const std::size_t children = alive_.size() / std::max<std::size_t>(1, coarse);
    std::vector<std::uint8_t> present(coarse, 0);
    for (std::size_t c = 0; c < alive_.size(); ++c) {
        present[c / children] |= alive_[c];
    }
    const std::vector<int> pieces = pieces_by_nodes(model.coarse.tets, model.coarse.nodes.size(), present);
    std::vector<int> of_node(model.coarse.nodes.size(), -1);
    for (std::size_t t = 0; t < coarse; ++t) {
        for (const int node : model.coarse.tets[t]) {
            of_node[node] = std::max(of_node[node], pieces[t]);
        }
    }
    in_pieces_ = false;
    for (SurfaceVertex& vertex : vertices_) {
        vertex.piece = of_node[vertex.nodes[0]];
        in_pieces_ = in_pieces_ || vertex.piece != vertices_.front().piece;
    }
}

void ContactSurface::normals(const std::vector<Vec3>& nodes, std::vector<Vec3>& normals) const {
    normals.assign(vertices_.size(), Vec3::Zero());
    for (const std::array<int, 3>& face : faces_) {
        const Vec3 a = point_of(vertices_[face[0]], nodes);
        const Vec3 area = (point_of(vertices_[face[1]], nodes) - a).cross(point_of(vertices_[face[2]], nodes) - a);
        for (const int vertex : face) {
            normals[vertex] += area;
        }
    }
    for (Vec3& normal : normals) {
        const double length = normal.norm();
        normal = length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
    }
}

}  // namespace rhexis
