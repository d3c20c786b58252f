// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/come_apart.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/components.hpp"
#include "mesh/tet_mesh.hpp"

namespace rhexis {

namespace {

bool alive(const SolidState& state, int fine) { return state.present[fine / 8] != 0 && state.fraction[fine] > 0.0; }

/// Pairs of neighbouring coarse tetrahedra that hold together, ascending.
std::vector<BrokenFace> held_pairs(const SolidModel& model, const SolidState& state,
                                   const std::vector<BrokenFace>& broken) {
    std::vector<BrokenFace> pairs;
    for (int f = 0; f < static_cast<int>(model.fine.tets.size()); ++f) {
        if (!alive(state, f)) {
            continue;
        }
        for (const int other : model.fine.neighbours[f]) {
            if (other > f && other / 8 != f / 8 && alive(state, other)) {
                pairs.push_back({std::min(f, other) / 8, std::max(f, other) / 8});
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::erase_if(pairs, [&](const BrokenFace& pair) {
        return std::binary_search(state.broken.begin(), state.broken.end(), pair) ||
               std::binary_search(broken.begin(), broken.end(), pair);
    });
    return pairs;
}

UnionFind joined(const std::vector<BrokenFace>& pairs, std::size_t tets) {
    UnionFind sets(static_cast<int>(tets));
    for (const BrokenFace& pair : pairs) {
        sets.join(pair[0], pair[1]);
    }
    return sets;
}

/// Nodes that two broken tetrahedra share.
std::vector<char> nodes_of_breaks(const SolidModel& model, const std::vector<BrokenFace>& broken) {
    std::vector<char> touched(model.coarse.nodes.size(), 0);
    for (const BrokenFace& pair : broken) {
        const std::array<int, 4>& other = model.coarse.tets[pair[1]];
        for (const int node : model.coarse.tets[pair[0]]) {
            touched[node] = std::find(other.begin(), other.end(), node) != other.end() ? 1 : touched[node];
        }
    }
    return touched;
}

/// The present tetrahedra around a node in groups that hold together around it; the group of the lowest first.
std::vector<std::vector<int>> groups_around(std::span<const int> star, const std::vector<BrokenFace>& pairs) {
    UnionFind sets(static_cast<int>(star.size()));
    for (std::size_t i = 0; i < star.size(); ++i) {
        for (std::size_t j = i + 1; j < star.size(); ++j) {
            if (std::binary_search(pairs.begin(), pairs.end(), BrokenFace{star[i], star[j]})) {
                sets.join(static_cast<int>(i), static_cast<int>(j));
            }
        }
    }
    std::vector<std::vector<int>> groups;
    std::map<int, std::size_t> number;
    for (std::size_t i = 0; i < star.size(); ++i) {
        const int set = sets.find(static_cast<int>(i));
        if (!number.contains(set)) {
            number[set] = groups.size();
            groups.emplace_back();
        }
        groups[number[set]].push_back(star[i]);
    }
    return groups;
}

/// Joins groups of the same piece: a hinge within a piece stays.
void join_same_piece(UnionFind& pieces, std::vector<std::vector<int>>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        for (std::size_t j = groups.size(); j-- > i + 1;) {
            if (pieces.find(groups[i].front()) == pieces.find(groups[j].front())) {
                groups[i].insert(groups[i].end(), groups[j].begin(), groups[j].end());
                groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
            }
        }
        std::sort(groups[i].begin(), groups[i].end());
    }
}

/// Numbers of edges in the order in which they are first asked for.
class EdgeNumbers {
public:
    explicit EdgeNumbers(std::size_t nodes) : upwards_(nodes) {}

    int number(int a, int b) {
        const int low = std::min(a, b);
        const int high = std::max(a, b);
        for (const auto& [end, number] : upwards_[at(low)]) {
            if (end == high) {
                return number;
            }
        }
        upwards_[at(low)].emplace_back(high, static_cast<int>(edges.size()));
        edges.push_back({low, high});
        return static_cast<int>(edges.size()) - 1;
    }

    std::vector<std::array<int, 2>> edges;

private:
    std::vector<std::vector<std::pair<int, int>>> upwards_;  ///< per node: other ends above it, and the edge's number
};

/// Neighbours stay where their common face has the same corners on both sides.
std::vector<std::array<int, 4>> kept_neighbours(const std::vector<std::array<int, 4>>& before,
                                                const std::vector<std::array<int, 4>>& tets) {
    std::vector<std::array<int, 4>> neighbours = before;
    for (std::size_t t = 0; t < tets.size(); ++t) {
        for (std::size_t k = 0; k < 4; ++k) {
            const int other = neighbours[t][k];
            const auto parted = [&](int local) {
                const std::array<int, 4>& beside = tets[at(other)];
                return std::find(beside.begin(), beside.end(), tets[t][at(local)]) == beside.end();
            };
            if (other >= 0 && std::any_of(tet_faces[k].begin(), tet_faces[k].end(), parted)) {
                neighbours[t][k] = -1;
            }
        }
    }
    return neighbours;
}

/// The same children with the corners that their coarse tetrahedra have now.
FineMesh follow_coarse(const SolidModel& base, const TetMesh& coarse) {
    FineMesh fine;
    const int old_nodes = static_cast<int>(base.coarse.nodes.size());
    const int nodes = static_cast<int>(coarse.nodes.size());
    EdgeNumbers numbers(coarse.nodes.size());
    fine.tets.reserve(base.fine.tets.size());
    for (std::size_t f = 0; f < base.fine.tets.size(); ++f) {
        const std::array<int, 4>& before = base.coarse.tets[f / 8];
        const std::array<int, 4>& now = coarse.tets[f / 8];
        const auto moved = [&](int node) {
            return now[static_cast<std::size_t>(std::find(before.begin(), before.end(), node) - before.begin())];
        };
        std::array<int, 4> tet = base.fine.tets[f];
        for (int& corner : tet) {
            if (corner < old_nodes) {
                corner = moved(corner);
                continue;
            }
            const std::array<int, 2>& ends = base.fine.edges[corner - old_nodes];
            corner = nodes + numbers.number(moved(ends[0]), moved(ends[1]));
        }
        fine.tets.push_back(tet);
    }
    fine.edges = std::move(numbers.edges);
    fine.neighbours = kept_neighbours(base.fine.neighbours, fine.tets);
    return fine;
}

}  // namespace

std::vector<int> pieces_of(const SolidModel& model, const SolidState& state) {
    UnionFind sets = joined(held_pairs(model, state, {}), model.coarse.tets.size());
    std::vector<int> pieces(model.coarse.tets.size(), -1);
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        pieces[t] = state.present[t] != 0 ? sets.find(static_cast<int>(t)) : -1;
    }
    return pieces;
}

MeshEdit come_apart(const SolidModel& model, const SolidState& state, int solid,
                    const std::vector<BrokenFace>& broken) {
    MeshEdit edit;
    edit.solid = solid;
    edit.broken = broken;
    const std::vector<BrokenFace> pairs = held_pairs(model, state, broken);
    UnionFind pieces = joined(pairs, model.coarse.tets.size());
    const std::vector<char> cracked = nodes_of_breaks(model, broken);
    const NodeTets around = node_tets(model.coarse.tets, static_cast<int>(model.coarse.nodes.size()));
    std::vector<int> star;
    for (std::size_t n = 0; n < model.coarse.nodes.size(); ++n) {
        star.clear();
        bool several = cracked[n] != 0;
        for (int i = around.offset[n]; i < around.offset[n + 1]; ++i) {
            if (state.present[around.tets[i]] != 0) {
                star.push_back(around.tets[i]);
                several = several || pieces.find(star.front()) != pieces.find(star.back());
            }
        }
        if (!several) {
            continue;
        }
        std::vector<std::vector<int>> groups = groups_around(star, pairs);
        if (cracked[n] == 0) {
            join_same_piece(pieces, groups);
        }
        for (std::size_t g = 1; g < groups.size(); ++g) {
            edit.splits.push_back({static_cast<int>(n), groups[g]});
        }
    }
    return edit;
}

SolidModel split_model(const SolidModel& base, const std::vector<NodeSplit>& splits) {
    SolidModel model = base;
    for (const NodeSplit& split : splits) {
        const int fresh = static_cast<int>(model.coarse.nodes.size());
        RHEXIS_ASSERT(split.node >= 0 && split.node < fresh);
        model.coarse.nodes.push_back(Vec3(model.coarse.nodes[split.node]));
        for (const int tet : split.tets) {
            std::replace(model.coarse.tets[tet].begin(), model.coarse.tets[tet].end(), split.node, fresh);
        }
        if (std::binary_search(model.fixed_nodes.begin(), model.fixed_nodes.end(), split.node)) {
            model.fixed_nodes.push_back(fresh);
        }
    }
    if (!splits.empty() && !base.fine.tets.empty()) {
        model.fine = follow_coarse(base, model.coarse);
    }
    return model;
}

bool splits_fit(const SolidModel& base, const std::vector<NodeSplit>& splits) {
    TetMesh mesh = base.coarse;
    int nodes = static_cast<int>(mesh.nodes.size());
    for (const NodeSplit& split : splits) {
        if (split.node < 0 || split.node >= nodes) {
            return false;
        }
        for (const int t : split.tets) {
            if (t < 0 || t >= static_cast<int>(mesh.tets.size())) {
                return false;
            }
            std::array<int, 4>& tet = mesh.tets[t];
            const auto found = std::find(tet.begin(), tet.end(), split.node);
            if (found == tet.end()) {
                return false;
            }
            *found = nodes;
        }
        ++nodes;
    }
    return true;
}

void apply_splits(const MeshEdit& edit, SolidState& state) {
    for (const NodeSplit& split : edit.splits) {
        state.position.push_back(Vec3(state.position[split.node]));
        state.velocity.push_back(Vec3(state.velocity[split.node]));
    }
    state.splits.insert(state.splits.end(), edit.splits.begin(), edit.splits.end());
    state.broken.insert(state.broken.end(), edit.broken.begin(), edit.broken.end());
    std::sort(state.broken.begin(), state.broken.end());
}

}  // namespace rhexis
