// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/gradient_elements.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "mesh/tet_patches.hpp"

namespace rhexis {
namespace {

constexpr int tets_of_patch = 4;

constexpr std::array<std::array<int, 2>, 6> tet_edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

void rest_shape(const TetMesh& mesh, ElementDomains& domains) {
    domains.rest_volume.reserve(mesh.tets.size());
    domains.rest_gradient.reserve(4 * mesh.tets.size());
    for (const std::array<int, 4>& tet : mesh.tets) {
        const Vec3& origin = mesh.nodes[at(tet[0])];
        Mat3 edges;
        edges << mesh.nodes[at(tet[1])] - origin, mesh.nodes[at(tet[2])] - origin, mesh.nodes[at(tet[3])] - origin;
        const double volume = edges.determinant() / 6.0;
        RHEXIS_ASSERT(volume > 0.0);
        const Mat3 inverse = edges.inverse();
        domains.rest_volume.push_back(volume);
        domains.rest_gradient.push_back(-(inverse.row(0) + inverse.row(1) + inverse.row(2)).transpose());
        for (int k = 0; k < 3; ++k) {
            domains.rest_gradient.push_back(inverse.row(k).transpose());
        }
    }
}

using Members = std::vector<std::vector<int>>;  ///< the tetrahedra of each element

Members each_alone(const TetMesh& mesh) {
    Members result;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        result.push_back({static_cast<int>(t)});
    }
    return result;
}

Members around_edges(const TetMesh& mesh) {
    std::map<std::array<int, 2>, std::vector<int>> around;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const std::array<int, 2>& edge : tet_edges) {
            const int a = mesh.tets[t][at(edge[0])];
            const int b = mesh.tets[t][at(edge[1])];
            around[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(t));
        }
    }
    Members result;
    for (std::pair<const std::array<int, 2>, std::vector<int>>& entry : around) {
        result.push_back(std::move(entry.second));
    }
    return result;
}

std::vector<int> element_nodes(const TetMesh& mesh, const ElementDomains& domains, int e) {
    std::vector<int> nodes;
    for (int i = domains.first[at(e)]; i < domains.first[at(e) + 1]; ++i) {
        const std::array<int, 4>& tet = mesh.tets[at(domains.tets[at(i)])];
        nodes.insert(nodes.end(), tet.begin(), tet.end());
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// Of lambda, what a tetrahedron gives to its elements of all energy, and to that of its patch.
double lambda_of(const TetStiffness& tet, Formulation formulation, bool patch) {
    if (formulation == Formulation::nodal_pressure) {
        return -2.0 / 3.0 * tet.mu;
    }
    if (formulation == Formulation::edge_smoothed) {
        const double own = std::min(tet.lambda, tet.mu);
        return patch ? tet.lambda - own : own;
    }
    return tet.lambda;
}

void fill_element(const TetMesh& mesh, const ElementDomains& domains, const std::vector<TetStiffness>& stiffness, int e,
                  GradientElements& elements) {
    const bool patch = e >= domains.first_patch;
    const double part = domains.formulation == Formulation::edge_smoothed && !patch ? 1.0 / 6.0 : 1.0;
    const int begin = elements.first[at(e)];
    const int end = elements.first[at(e) + 1];
    for (int k = begin; k < end; ++k) {
        elements.gradient[at(k)].setZero();
    }
    double volume = 0.0;
    double lambda = 0.0;
    double mu = 0.0;
    for (int i = domains.first[at(e)]; i < domains.first[at(e) + 1]; ++i) {
        const int t = domains.tets[at(i)];
        const TetStiffness& own = stiffness[at(t)];
        const double weight = part * own.share * domains.rest_volume[at(t)];
        volume += weight;
        lambda += weight * lambda_of(own, domains.formulation, patch);
        mu += patch ? 0.0 : weight * own.mu;
        for (int corner = 0; corner < 4; ++corner) {
            const int node = mesh.tets[at(t)][at(corner)];
            const auto slot = std::lower_bound(elements.node.begin() + begin, elements.node.begin() + end, node);
            elements.gradient[static_cast<std::size_t>(slot - elements.node.begin())] +=
                weight * domains.rest_gradient[at(4 * t + corner)];
        }
    }
    const double scale = volume > 0.0 ? 1.0 / volume : 0.0;
    for (int k = begin; k < end; ++k) {
        elements.gradient[at(k)] *= scale;
    }
    elements.volume[at(e)] = volume;
    elements.lambda[at(e)] = lambda * scale;
    elements.mu[at(e)] = mu * scale;
}

}  // namespace

ElementDomains element_domains(const TetMesh& mesh, Formulation formulation) {
    ElementDomains domains;
    domains.formulation = formulation;
    rest_shape(mesh, domains);
    const bool smoothed = formulation == Formulation::edge_smoothed;
    Members elements = smoothed ? around_edges(mesh) : each_alone(mesh);
    domains.first_patch = static_cast<int>(elements.size());
    if (smoothed) {
        const Members patches = tet_patches(mesh.tets, tets_of_patch);
        elements.insert(elements.end(), patches.begin(), patches.end());
    }
    Members of_tet(mesh.tets.size());
    domains.first.push_back(0);
    for (const std::vector<int>& tets : elements) {
        const int element = static_cast<int>(domains.first.size()) - 1;
        for (const int t : tets) {
            domains.tets.push_back(t);
            of_tet[at(t)].push_back(element);
        }
        domains.first.push_back(static_cast<int>(domains.tets.size()));
    }
    domains.of_tet_first.push_back(0);
    for (const std::vector<int>& list : of_tet) {
        domains.of_tet.insert(domains.of_tet.end(), list.begin(), list.end());
        domains.of_tet_first.push_back(static_cast<int>(domains.of_tet.size()));
    }
    return domains;
}

GradientElements make_elements(const TetMesh& mesh, const ElementDomains& domains,
                               const std::vector<TetStiffness>& stiffness) {
    RHEXIS_ASSERT(stiffness.size() == mesh.tets.size());
    GradientElements elements;
    const int count = static_cast<int>(domains.first.size()) - 1;
    elements.first.push_back(0);
    for (int e = 0; e < count; ++e) {
        const std::vector<int> nodes = element_nodes(mesh, domains, e);
        elements.node.insert(elements.node.end(), nodes.begin(), nodes.end());
        elements.first.push_back(static_cast<int>(elements.node.size()));
    }
    elements.gradient.resize(elements.node.size());
    elements.volume.resize(at(count));
    elements.lambda.resize(at(count));
    elements.mu.resize(at(count));
    for (int e = 0; e < count; ++e) {
        fill_element(mesh, domains, stiffness, e, elements);
    }
    return elements;
}

void update_elements(const TetMesh& mesh, const ElementDomains& domains, const std::vector<TetStiffness>& stiffness,
                     const std::vector<int>& changed_tets, GradientElements& elements) {
    std::vector<int> stale;
    for (const int t : changed_tets) {
        for (int i = domains.of_tet_first[at(t)]; i < domains.of_tet_first[at(t) + 1]; ++i) {
            stale.push_back(domains.of_tet[at(i)]);
        }
    }
    std::sort(stale.begin(), stale.end());
    stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
    for (const int e : stale) {
        fill_element(mesh, domains, stiffness, e, elements);
    }
}

}  // namespace rhexis
