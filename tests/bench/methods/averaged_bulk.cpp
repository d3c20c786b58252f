// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/averaged_bulk.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/index.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/tet_patches.hpp"

namespace rhexis::bench {
namespace {

using Groups = std::vector<std::vector<int>>;  ///< tetrahedra of each element

Groups around_edges(const TetMesh& mesh) {
    const ElementDomains domains = element_domains(mesh, Formulation::edge_smoothed);
    Groups groups;
    for (int e = 0; e < domains.first_patch; ++e) {
        groups.emplace_back(domains.tets.begin() + domains.first[at(e)],
                            domains.tets.begin() + domains.first[at(e + 1)]);
    }
    return groups;
}

Groups around_nodes(const TetMesh& mesh) {
    Groups groups(mesh.nodes.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const int node : mesh.tets[t]) {
            groups[at(node)].push_back(static_cast<int>(t));
        }
    }
    return groups;
}

Groups around_some_nodes(const TetMesh& mesh) {
    constexpr int none = -1;
    Groups around = around_nodes(mesh);
    std::stable_sort(around.begin(), around.end(),
                     [](const std::vector<int>& a, const std::vector<int>& b) { return a.size() > b.size(); });
    std::vector<int> of_tet(mesh.tets.size(), none);
    Groups groups;
    for (const std::vector<int>& own : around) {
        if (!own.empty() && std::all_of(own.begin(), own.end(), [&](int t) { return of_tet[at(t)] == none; })) {
            for (const int t : own) {
                of_tet[at(t)] = static_cast<int>(groups.size());
            }
            groups.push_back(own);
        }
    }
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(mesh.tets);
    for (bool again = true; again;) {
        again = false;
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            int best = none;
            for (const int other : neighbours[t]) {
                const int found = of_tet[t] != none || other < 0 ? none : of_tet[at(other)];
                if (found != none && (best == none || groups[at(found)].size() < groups[at(best)].size())) {
                    best = found;
                }
            }
            if (best != none) {
                of_tet[t] = best;
                groups[at(best)].push_back(static_cast<int>(t));
                again = true;
            }
        }
    }
    return groups;
}

/// One element per group: the volume mean of its tetrahedra, of each of which it has the part `part`.
GradientElements averaged(const TetMesh& mesh, const Groups& groups, double part,
                          const std::vector<TetStiffness>& stiffness) {
    const ElementDomains domains = element_domains(mesh, Formulation::linear);
    GradientElements elements;
    elements.first.push_back(0);
    for (const std::vector<int>& group : groups) {
        std::map<int, Vec3> gradient;
        double volume = 0.0;
        double lambda = 0.0;
        double mu = 0.0;
        for (const int t : group) {
            const double weight = part * domains.rest_volume[at(t)];
            volume += weight;
            lambda += weight * stiffness[at(t)].lambda;
            mu += weight * stiffness[at(t)].mu;
            for (int k = 0; k < 4; ++k) {
                gradient.try_emplace(mesh.tets[at(t)][at(k)], Vec3::Zero()).first->second +=
                    weight * domains.rest_gradient[at(4 * t + k)];
            }
        }
        for (const auto& [node, b] : gradient) {
            elements.node.push_back(node);
            elements.gradient.push_back(b / volume);
        }
        elements.first.push_back(static_cast<int>(elements.node.size()));
        elements.volume.push_back(volume);
        elements.lambda.push_back(lambda / volume);
        elements.mu.push_back(mu / volume);
    }
    return elements;
}

}  // namespace

std::vector<GradientElements> averaged_bulk(const TetMesh& mesh, const std::vector<TetStiffness>& stiffness,
                                            const AveragedBulk& way) {
    const Groups edges = around_edges(mesh);
    if (way.over == BulkOver::edges) {
        return {averaged(mesh, edges, 1.0 / 6.0, stiffness)};
    }
    std::vector<TetStiffness> kept = stiffness;
    std::vector<TetStiffness> rest = stiffness;
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        kept[t].lambda = std::min(stiffness[t].lambda, way.kept * stiffness[t].mu);
        rest[t].lambda = stiffness[t].lambda - kept[t].lambda;
        rest[t].mu = 0.0;
    }
    const Groups groups = way.over == BulkOver::nodes     ? around_nodes(mesh)
                          : way.over == BulkOver::patches ? tet_patches(mesh.tets, way.tetrahedra)
                                                          : around_some_nodes(mesh);
    return {averaged(mesh, edges, 1.0 / 6.0, kept),
            averaged(mesh, groups, way.over == BulkOver::nodes ? 0.25 : 1.0, rest)};
}

}  // namespace rhexis::bench
