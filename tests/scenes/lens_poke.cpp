// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/lens_poke.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "energy/corotational.hpp"
#include "energy/nodal_pressure.hpp"
#include "mesh/surface.hpp"
#include "physics/solid/solid_share.hpp"
#include "scenes/bodies.hpp"

namespace rhexis::scenes {
namespace {

/// Each anterior triangle, cut into 16, gives its load to its corners by the linear shape functions.
void add_triangle(const PokeLoad& load, const std::vector<Vec3>& nodes, const std::array<int, 3>& triangle,
                  std::vector<double>& weight) {
    constexpr int cuts = 16;
    const Vec3& a = nodes[at(triangle[0])];
    const Vec3& b = nodes[at(triangle[1])];
    const Vec3& c = nodes[at(triangle[2])];
    const double projected = 0.5 * (b - a).cross(c - a).z();
    if (projected <= 0.0) {
        return;
    }
    for (int i = 0; i < cuts; ++i) {
        for (int j = 0; j < cuts - i; ++j) {
            const double u = (i + 1.0 / 3.0) / cuts;
            const double v = (j + 1.0 / 3.0) / cuts;
            const double p = projected * poke_pressure(load, a + u * (b - a) + v * (c - a));
            weight[at(triangle[0])] += (1.0 - u - v) * p;
            weight[at(triangle[1])] += u * p;
            weight[at(triangle[2])] += v * p;
        }
    }
}

void add_load(const PokeLoad& load, const Surface& surface, LensPoke& poke) {
    const std::vector<Vec3>& nodes = poke.lens.coarse.nodes;
    std::vector<double> weight(nodes.size(), 0.0);
    for (const std::array<int, 3>& triangle : surface.triangles) {
        if (nodes[at(triangle[0])].z() > 0.0) {
            add_triangle(load, nodes, triangle, weight);
        }
    }
    double sum = 0.0;
    for (const double w : weight) {
        sum += w;
    }
    RHEXIS_ASSERT(sum > 0.0);
    for (const double w : weight) {
        poke.nodal_load.emplace_back(0.0, 0.0, -load.total * w / sum);
    }
}

/// The patches of nodal pressure as elements that feel changes of volume only. Small strain.
GradientElements patch_elements(const TetMesh& mesh, const ElementDomains& domains,
                                const std::vector<TetStiffness>& stiffness) {
    const NodePatches patches = node_patches(mesh, domains.rest_volume, stiffness);
    std::vector<std::map<int, Vec3>> gradient(mesh.nodes.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const double weight = 0.25 * stiffness[t].share * domains.rest_volume[t];
        for (const int node : mesh.tets[t]) {
            for (std::size_t a = 0; a < 4; ++a) {
                const auto entry = gradient[at(node)].try_emplace(mesh.tets[t][a], Vec3::Zero()).first;
                entry->second += weight / patches.volume[at(node)] * domains.rest_gradient[4 * t + a];
            }
        }
    }
    GradientElements elements;
    elements.first.push_back(0);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        for (const auto& [node, b] : gradient[n]) {
            elements.node.push_back(node);
            elements.gradient.push_back(b);
        }
        elements.first.push_back(static_cast<int>(elements.node.size()));
        elements.volume.push_back(patches.volume[n]);
        elements.lambda.push_back(patches.bulk[n]);
        elements.mu.push_back(0.0);
    }
    return elements;
}

/// Blocks of the linear stiffness between nodes that are not held.
void add_stiffness(const GradientElements& elements, const std::vector<char>& held,
                   std::vector<Eigen::Triplet<double>>& entries) {
    for (int e = 0; e < elements.count(); ++e) {
        const CorotationalTangent tangent =
            corotational_tangent({}, {elements.lambda[at(e)], elements.mu[at(e)]}, Tangent::warped);
        for (int i = elements.first[at(e)]; i < elements.first[at(e) + 1]; ++i) {
            for (int j = elements.first[at(e)]; j < elements.first[at(e) + 1]; ++j) {
                const int row = elements.node[at(i)];
                const int column = elements.node[at(j)];
                if (held[at(row)] != 0 || held[at(column)] != 0) {
                    continue;
                }
                const Mat3 block =
                    elements.volume[at(e)] * tangent.block(elements.gradient[at(i)], elements.gradient[at(j)]);
                for (int k = 0; k < 9; ++k) {
                    entries.emplace_back(3 * row + k % 3, 3 * column + k / 3, block(k % 3, k / 3));
                }
            }
        }
    }
}

}  // namespace

double poke_pressure(const PokeLoad& load, const Vec3& point) {
    const double share = point.head<2>().squaredNorm() / (load.radius * load.radius);
    return share < 1.0 ? (1.0 - share) * (1.0 - share) : 0.0;
}

LensPoke lens_poke(int tetrahedra, const PokeLoad& load) {
    LensPoke poke;
    poke.load = load;
    poke.lens = default_eye(tetrahedra).lens;
    const Surface surface = surface_of(poke.lens.coarse);
    for (const int node : surface.vertices) {
        if (poke.lens.coarse.nodes[at(node)].z() < load.held_below) {
            poke.lens.fixed_nodes.push_back(node);
        }
    }
    add_load(load, surface, poke);
    return poke;
}

double poke_depth(const LensPoke& poke, const std::vector<Vec3>& position) {
    double work = 0.0;
    Vec3 total = Vec3::Zero();
    for (std::size_t i = 0; i < position.size(); ++i) {
        work += poke.nodal_load[i].dot(position[i] - poke.lens.coarse.nodes[i]);
        total += poke.nodal_load[i];
    }
    return work / total.norm();
}

double linear_compliance(const LensPoke& poke, Formulation formulation) {
    const TetMesh& mesh = poke.lens.coarse;
    const std::vector<TetStiffness> stiffness = tet_stiffness(poke.lens, rest_state(poke.lens));
    const ElementDomains domains = element_domains(mesh, formulation);
    std::vector<GradientElements> elements{make_elements(mesh, domains, stiffness)};
    if (formulation == Formulation::nodal_pressure) {
        elements.push_back(patch_elements(mesh, domains, stiffness));
    }
    return linear_compliance(poke, elements);
}

double linear_compliance(const LensPoke& poke, const std::vector<GradientElements>& elements) {
    std::vector<char> held(poke.lens.coarse.nodes.size(), 0);
    for (const int node : poke.lens.fixed_nodes) {
        held[at(node)] = 1;
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const GradientElements& some : elements) {
        add_stiffness(some, held, entries);
    }
    const int size = 3 * static_cast<int>(held.size());
    VecX load = VecX::Zero(size);
    for (int node = 0; node < size / 3; ++node) {
        if (held[at(node)] != 0) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * node + k, 3 * node + k, 1.0);
            }
        } else {
            load.segment<3>(3 * node) = poke.nodal_load[at(node)];
        }
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    RHEXIS_ASSERT(factor.info() == Eigen::Success);
    const VecX moved = factor.solve(load);
    double total = 0.0;
    for (const Vec3& f : poke.nodal_load) {
        total -= f.z();
    }
    return load.dot(moved) / (total * total);
}

}  // namespace rhexis::scenes
