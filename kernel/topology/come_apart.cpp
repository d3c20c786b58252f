// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/come_apart.hpp"

#include <algorithm>
#include <iterator>
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

/// The coarse tetrahedra above one that a pair of fine ones on either side of a common face joins to it, ascending.
void held_above(const SolidModel& model, const SolidState& state, int t, std::vector<int>& others) {
    others.clear();
    for (int f = 8 * t; f < 8 * t + 8; ++f) {
        for (const int beside : model.fine.neighbours[f]) {
            if (beside / 8 > t && alive(state, f) && alive(state, beside)) {
                others.push_back(beside / 8);
            }
        }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
}

/// Pairs of neighbouring coarse tetrahedra that hold together, ascending.
std::vector<BrokenFace> held_pairs(const SolidModel& model, const SolidState& state,
                                   const std::vector<BrokenFace>& broken) {
    std::vector<BrokenFace> joined;
    std::vector<int> others;
    for (int t = 0; t < static_cast<int>(model.fine.tets.size() / 8); ++t) {
        held_above(model, state, t, others);
        for (const int other : others) {
            joined.push_back({t, other});
        }
    }
    std::vector<BrokenFace> whole;
    std::set_difference(joined.begin(), joined.end(), state.broken.begin(), state.broken.end(),
                        std::back_inserter(whole));
    std::vector<BrokenFace> held;
    std::set_difference(whole.begin(), whole.end(), broken.begin(), broken.end(), std::back_inserter(held));
    return held;
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

/// Numbers of the edges of a mesh after nodes were split. Who has an edge first keeps its number; where others of those
/// that had it have other ends now, each pair of ends gets a further number.
class EdgeNumbers {
public:
    explicit EdgeNumbers(const std::vector<std::array<int, 2>>& before) : edges(before), own_(before.size()) {}

    int number(int edge, std::array<int, 2> ends) {
        std::sort(ends.begin(), ends.end());
        std::vector<int>& own = own_[at(edge)];
        for (const int known : own) {
            if (edges[known] == ends) {
                return known;
            }
        }
        own.push_back(own.empty() ? edge : static_cast<int>(edges.size()));
        edges.resize(std::max(edges.size(), at(own.back() + 1)));
        edges[own.back()] = ends;
        return own.back();
    }

    std::vector<std::array<int, 2>> edges;

private:
    std::vector<std::vector<int>> own_;  ///< per edge before: the numbers of what it is now; empty: not asked for
};

/// The coarse tetrahedra that have another node than before.
std::vector<char> moved_tets(const TetMesh& before, const TetMesh& now) {
    std::vector<char> moved(now.tets.size());
    std::transform(now.tets.begin(), now.tets.end(), before.tets.begin(), moved.begin(),
                   [](const std::array<int, 4>& a, const std::array<int, 4>& b) { return a == b ? 0 : 1; });
    return moved;
}

/// Edges of the fine mesh that one of these coarse tetrahedra has.
std::vector<char> edges_of(const SolidModel& base, const std::vector<char>& tets) {
    const int nodes = static_cast<int>(base.coarse.nodes.size());
    std::vector<char> found(base.fine.edges.size(), 0);
    for (std::size_t f = 0; f < base.fine.tets.size(); ++f) {
        for (const int corner : base.fine.tets[f]) {
            if (tets[f / 8] != 0 && corner >= nodes) {
                found[corner - nodes] = 1;
            }
        }
    }
    return found;
}

/// Neighbours whose common face has no more the same corners on both sides forget each other.
void part_neighbours(const std::vector<char>& moved, FineMesh& fine) {
    for (std::size_t f = 0; f < fine.tets.size(); ++f) {
        for (std::size_t k = 0; moved[f / 8] != 0 && k < 4; ++k) {
            const int other = fine.neighbours[f][k];
            const auto parted = [&](int local) {
                const std::array<int, 4>& beside = fine.tets[at(other)];
                return std::find(beside.begin(), beside.end(), fine.tets[f][at(local)]) == beside.end();
            };
            if (other >= 0 && std::any_of(tet_faces[k].begin(), tet_faces[k].end(), parted)) {
                fine.neighbours[f][k] = -1;
                std::array<int, 4>& back = fine.neighbours[at(other)];
                std::replace(back.begin(), back.end(), static_cast<int>(f), -1);
            }
        }
    }
}

/// The same children with the corners that their coarse tetrahedra have now.
FineMesh follow_coarse(const SolidModel& base, const TetMesh& coarse) {
    const int old_nodes = static_cast<int>(base.coarse.nodes.size());
    const int nodes = static_cast<int>(coarse.nodes.size());
    const std::vector<char> moved = moved_tets(base.coarse, coarse);
    const std::vector<char> touched = edges_of(base, moved);
    FineMesh fine = base.fine;
    EdgeNumbers numbers(base.fine.edges);
    for (std::size_t f = 0; f < fine.tets.size(); ++f) {
        const std::array<int, 4>& before = base.coarse.tets[f / 8];
        const auto now = [&](int node) {
            return coarse
                .tets[f / 8][at(static_cast<int>(std::find(before.begin(), before.end(), node) - before.begin()))];
        };
        for (int& corner : fine.tets[f]) {
            const int edge = corner - old_nodes;
            if (edge < 0) {
                corner = moved[f / 8] != 0 ? now(corner) : corner;
            } else if (touched[edge] == 0) {
                corner = nodes + edge;
            } else {
                const std::array<int, 2>& ends = base.fine.edges[edge];
                corner = nodes + numbers.number(edge, {now(ends[0]), now(ends[1])});
            }
        }
    }
    fine.edges = std::move(numbers.edges);
    part_neighbours(moved, fine);
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
