// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/node_stiffness.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "energy/nodal_pressure.hpp"
#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

std::array<Vec3, 4> shape_gradients(const TetMesh& mesh, const std::array<int, 4>& tet) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) {
        edges.col(k) = mesh.nodes[tet[k + 1]] - mesh.nodes[tet[0]];
    }
    const Mat3 inverse = edges.inverse();
    const Vec3 sum = inverse.colwise().sum().transpose();
    return {Vec3(-sum), inverse.row(0).transpose(), inverse.row(1).transpose(), inverse.row(2).transpose()};
}

}  // namespace

NodeStiffness::NodeStiffness(const TetMesh& mesh, Formulation formulation) : mesh_(&mesh), formulation_(formulation) {
    for (const std::array<int, 4>& tet : mesh.tets) {
        gradients_.push_back(shape_gradients(mesh, tet));
        volumes_.push_back(tet_volume(mesh.nodes[tet[0]], mesh.nodes[tet[1]], mesh.nodes[tet[2]], mesh.nodes[tet[3]]));
    }
    if (formulation_ != Formulation::nodal_pressure) {
        return;
    }
    pair_.resize(mesh.tets.size());
    const NodeTets around = node_tets(mesh.tets, static_cast<int>(mesh.nodes.size()));
    for (std::size_t patch = 0; patch < mesh.nodes.size(); ++patch) {
        add_rows(static_cast<int>(patch),
                 std::span(around.tets)
                     .subspan(at(around.offset[patch]), at(around.offset[patch + 1] - around.offset[patch])));
    }
}

/// A row for each node of the tetrahedra around one, ascending.
void NodeStiffness::add_rows(int patch, std::span<const int> star) {
    const std::size_t begin = node_.size();
    for (const int t : star) {
        const std::array<int, 4>& tet = mesh_->tets[at(t)];
        node_.insert(node_.end(), tet.begin(), tet.end());
    }
    const auto first = node_.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, node_.end());
    node_.erase(std::unique(first, node_.end()), node_.end());
    patch_.resize(node_.size(), patch);
    for (const int t : star) {
        const std::array<int, 4>& tet = mesh_->tets[at(t)];
        const std::size_t own = 4 * static_cast<std::size_t>(std::find(tet.begin(), tet.end(), patch) - tet.begin());
        for (std::size_t k = 0; k < 4; ++k) {
            const auto row = std::lower_bound(node_.begin() + static_cast<std::ptrdiff_t>(begin), node_.end(), tet[k]);
            pair_[at(t)][own + k] = static_cast<int>(row - node_.begin());
        }
    }
}

const std::vector<double>& NodeStiffness::traces(const std::vector<TetStiffness>& shares) {
    traces_.assign(mesh_->nodes.size(), 0.0);
    const bool nodal = formulation_ == Formulation::nodal_pressure;
    dilation_.assign(patch_.size(), Vec3::Zero());
    for (std::size_t t = 0; t < shares.size(); ++t) {
        const TetStiffness& own = shares[t];
        if (!(own.share > 0.0)) {
            continue;
        }
        const double volume = own.share * volumes_[t];
        // mu |g|^2 I + (lambda + mu) g g^T
        const double factor = volume * (4.0 * own.mu + (nodal ? -2.0 / 3.0 * own.mu : own.lambda));
        for (std::size_t i = 0; i < 4; ++i) {
            traces_[mesh_->tets[t][i]] += factor * gradients_[t][i].squaredNorm();
        }
        for (std::size_t k = 0; nodal && k < 16; ++k) {
            dilation_[pair_[t][k]] += 0.25 * volume * gradients_[t][k % 4];
        }
    }
    if (nodal) {
        const NodePatches patches = node_patches(*mesh_, volumes_, shares);
        for (std::size_t row = 0; row < patch_.size(); ++row) {
            const double volume = patches.volume[patch_[row]];
            if (volume > 0.0) {
                traces_[node_[row]] += patches.bulk[patch_[row]] / volume * dilation_[row].squaredNorm();
            }
        }
    }
    return traces_;
}

}  // namespace rhexis
