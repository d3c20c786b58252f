// SPDX-License-Identifier: GPL-3.0-or-later
// Shells and sheets as surfaces that are verified.
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "base/index.hpp"
#include "physics/shell/shell_pose.hpp"
#include "physics/shell/shell_samples.hpp"
#include "scenes/penetration.hpp"

namespace rhexis::scenes {
namespace {

constexpr double layer_thicknesses = 1.5;  // as of the shell's contact

/// Nodes nearer to a triangle than a reach along edges, ascending: distances fall until none does.
std::vector<int> nodes_near(const std::vector<std::map<int, double>>& edges, const std::array<int, 3>& triangle,
                            double reach) {
    std::map<int, double> distance;
    std::vector<int> open(triangle.begin(), triangle.end());
    for (const int node : triangle) {
        distance[node] = 0.0;
    }
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        for (const auto& [other, length] : edges[at(node)]) {
            const double along = distance[node] + length;
            const auto [known, added] = distance.try_emplace(other, std::numeric_limits<double>::max());
            if (along < reach && along < known->second) {
                known->second = along;
                open.push_back(other);
            }
        }
    }
    std::vector<int> near;
    for (const auto& [node, along] : distance) {
        if (along < reach) {
            near.push_back(node);
        }
    }
    return near;
}

std::vector<std::map<int, double>> lengths_of(const TriMesh& mesh) {
    std::vector<std::map<int, double>> edges(mesh.nodes.size());
    for (const std::array<int, 3>& n : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = n[k];
            const int b = n[(k + 1) % 3];
            edges[at(a)][b] = edges[at(b)][a] = (mesh.nodes[at(a)] - mesh.nodes[at(b)]).norm();
        }
    }
    return edges;
}

}  // namespace

Skin shell_skin(const ShellModel& model, int level) {
    const ShellSamples on = shell_samples(model, level);
    Skin skin;
    skin.triangles = on.facets;
    for (const ShellSamples::Sample& sample : on.samples) {
        skin.half.push_back(0.5 * sample.place.thickness);
        skin.nodes.push_back(sample.place.nodes);
    }
    skin.place.resize(skin.half.size());
    std::iota(skin.place.begin(), skin.place.end(), 0);
    for (std::size_t f = 0; f < on.facets.size(); ++f) {
        skin.parent.push_back(static_cast<int>(f) / on.facets_each);
    }
    const std::vector<std::map<int, double>> edges = lengths_of(model.mesh);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        skin.near.push_back(nodes_near(edges, model.mesh.triangles[t], layer_thicknesses * model.thickness[t]));
    }
    return skin;
}

std::vector<Vec3> skin_places(const ShellModel& model, const ShellState& state, int level) {
    std::vector<Vec3> points;
    for (const Vec3& position : state.position) {
        points.push_back(position);
        points.push_back(Vec3::Zero());
    }
    ShellPose pose;
    pose.set(state.rotation, points);
    std::vector<Vec3> places;
    for (const ShellSamples::Sample& sample : shell_samples(model, level).samples) {
        places.push_back(pose.at(sample.place));
    }
    return places;
}

Skin sheet_skin(const MembraneSheet& sheet, double layer_distance) {
    Skin skin;
    std::map<std::array<double, 3>, int> known;
    for (const Vec3& node : sheet.mesh.nodes) {
        const int next = static_cast<int>(known.size());
        skin.place.push_back(known.try_emplace({node.x(), node.y(), node.z()}, next).first->second);
        skin.half.push_back(0.5 * layer_distance);
        skin.nodes.push_back({skin.place.back(), -1, -1});
    }
    for (const std::array<int, 3>& n : sheet.mesh.triangles) {
        skin.parent.push_back(static_cast<int>(skin.triangles.size()));
        skin.triangles.push_back(n);
        skin.near.push_back({skin.place[at(n[0])], skin.place[at(n[1])], skin.place[at(n[2])]});
        std::sort(skin.near.back().begin(), skin.near.back().end());
    }
    return skin;
}

}  // namespace rhexis::scenes
