// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shell_surface.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace rhexis {

ShellSurface::ShellSurface(const ShellModel& model) : node_(model.mesh.nodes) {
    find_normals(model.mesh);
    find_thickness(model);
    const std::vector<int> side_of = split(model.mesh);
    close(model.mesh, side_of);
    edges_ = edges_of(triangles_);
    rest_ = places(rest_state(model));
}

void ShellSurface::find_normals(const TriMesh& mesh) {
    normal_.assign(node_.size(), Vec3::Zero());
    for (const std::array<int, 3>& t : mesh.triangles) {
        const Vec3 twice_area = (node_[at(t[1])] - node_[at(t[0])]).cross(node_[at(t[2])] - node_[at(t[0])]);
        for (const int node : t) {
            normal_[at(node)] += twice_area;
        }
    }
    for (Vec3& normal : normal_) {
        normal.normalize();
    }
}

/// The mean of the triangles around.
void ShellSurface::find_thickness(const ShellModel& model) {
    thickness_.assign(node_.size(), 0.0);
    std::vector<int> count(node_.size(), 0);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        for (const int node : model.mesh.triangles[t]) {
            thickness_[at(node)] += model.thickness[t];
            ++count[at(node)];
        }
    }
    for (std::size_t n = 0; n < thickness_.size(); ++n) {
        thickness_[n] /= std::max(count[n], 1);
    }
}

/// Finds the sides, in order; three per triangle, opposite to each corner.
std::vector<int> ShellSurface::split(const TriMesh& mesh) {
    for (const SheetEdge& edge : edges_of(mesh.triangles)) {
        sides_.push_back({edge.from, edge.to, edge.right < 0});
    }
    std::vector<int> side_of;
    for (const std::array<int, 3>& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
            const std::array key{low, high};
            const auto found =
                std::lower_bound(sides_.begin(), sides_.end(), key, [](const Side& side, const std::array<int, 2>& of) {
                    return std::array{side.from, side.to} < of;
                });
            side_of.push_back(static_cast<int>(found - sides_.begin()));
        }
    }
    return side_of;
}

/// Nodes of the front: those of the shell, then the middles of its sides; then as many of the back.
void ShellSurface::close(const TriMesh& mesh, const std::vector<int>& side_of) {
    const int nodes = static_cast<int>(node_.size());
    const int back = nodes + static_cast<int>(sides_.size());
    const auto both = [&](int a, int b, int c) {
        triangles_.push_back({a, b, c});
        triangles_.push_back({back + a, back + c, back + b});
    };
    const auto rim = [&](int a, int b) {  // a to b as the front's triangle goes
        triangles_.push_back({b, a, back + a});
        triangles_.push_back({b, back + a, back + b});
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<int, 3>& corner = mesh.triangles[t];
        std::array<int, 3> middle{};
        for (std::size_t k = 0; k < 3; ++k) {
            middle[k] = nodes + side_of[3 * t + k];
        }
        both(corner[0], middle[2], middle[1]);
        both(corner[1], middle[0], middle[2]);
        both(corner[2], middle[1], middle[0]);
        both(middle[0], middle[1], middle[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            if (sides_[at(side_of[3 * t + k])].open) {
                rim(corner[(k + 1) % 3], middle[k]);
                rim(middle[k], corner[(k + 2) % 3]);
            }
        }
    }
}

std::vector<Vec3> ShellSurface::places(const ShellState& state) const {
    std::vector<Vec3> middle = state.position;
    std::vector<Vec3> half;  // from the middle to the front
    for (std::size_t n = 0; n < node_.size(); ++n) {
        half.push_back(0.5 * thickness_[n] * (state.rotation[n] * normal_[n]));
    }
    for (const Side& side : sides_) {
        const Vec3 along = node_[at(side.to)] - node_[at(side.from)];
        const Vec3 bow = 0.125 * (state.rotation[at(side.from)] * along - state.rotation[at(side.to)] * along);
        middle.push_back(0.5 * (state.position[at(side.from)] + state.position[at(side.to)]) + bow);
        const double length = 0.25 * (thickness_[at(side.from)] + thickness_[at(side.to)]);
        half.push_back(length * (half[at(side.from)] + half[at(side.to)]).normalized());
    }
    std::vector<Vec3> result;
    for (const double way : {1.0, -1.0}) {
        for (std::size_t n = 0; n < middle.size(); ++n) {
            result.push_back(middle[n] + way * half[n]);
        }
    }
    return result;
}

}  // namespace rhexis
