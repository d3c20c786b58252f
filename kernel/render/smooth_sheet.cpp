// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/smooth_sheet.hpp"

#include <algorithm>

namespace rhexis {

namespace {

constexpr int level_count = 1;
constexpr int most_triangles = 40000;  ///< beyond which a sheet is fine enough

using Triangles = std::vector<std::array<int, 3>>;

int find_edge(const std::vector<SheetEdge>& edges, int a, int b) {
    const std::array key{std::min(a, b), std::max(a, b)};
    const auto found =
        std::lower_bound(edges.begin(), edges.end(), key, [](const SheetEdge& edge, const std::array<int, 2>& wanted) {
            return std::array{edge.from, edge.to} < wanted;
        });
    return static_cast<int>(found - edges.begin());
}

void add(Refinement& rule, int node, double weight) {
    rule.node.push_back(node);
    rule.weight.push_back(weight);
}

void end_node(Refinement& rule) { rule.offset.push_back(static_cast<int>(rule.node.size())); }

/// Loop's rule for a node that stays: nodes on an edge look only along it.
void add_old_node(int node, const std::vector<int>& around, const std::vector<int>& along_edge, Refinement& rule) {
    const std::vector<int>& used = along_edge.empty() ? around : along_edge;
    const double count = static_cast<double>(used.size());
    const double share = along_edge.empty() ? (used.size() == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * count)) : 0.25 / count;
    add(rule, node, 1.0 - share * count);
    for (int other : used) {
        add(rule, other, share);
    }
    end_node(rule);
}

void add_edge_node(const SheetEdge& edge, Refinement& rule) {
    const bool open = edge.right < 0;
    add(rule, edge.from, open ? 0.5 : 0.375);
    add(rule, edge.to, open ? 0.5 : 0.375);
    if (!open) {
        add(rule, edge.left, 0.125);
        add(rule, edge.right, 0.125);
    }
    end_node(rule);
}

/// Replaces the triangles by four each; the old nodes come first, then one for each edge.
Refinement refine(Triangles& triangles, int node_count) {
    const std::vector<SheetEdge> edges = edges_of(triangles);
    std::vector<std::vector<int>> around(node_count);
    std::vector<std::vector<int>> along_edge(node_count);
    for (const SheetEdge& edge : edges) {
        for (const auto& [node, other] : {std::pair{edge.from, edge.to}, std::pair{edge.to, edge.from}}) {
            around[node].push_back(other);
            if (edge.right < 0) {
                along_edge[node].push_back(other);
            }
        }
    }
    Refinement rule;
    rule.offset.push_back(0);
    for (int node = 0; node < node_count; ++node) {
        add_old_node(node, around[node], along_edge[node], rule);
    }
    for (const SheetEdge& edge : edges) {
        add_edge_node(edge, rule);
    }
    Triangles finer;
    for (const std::array<int, 3>& t : triangles) {
        std::array<int, 3> middle{};
        for (int k = 0; k < 3; ++k) {
            middle[k] = node_count + find_edge(edges, t[(k + 1) % 3], t[(k + 2) % 3]);
        }
        finer.insert(finer.end(), {{t[0], middle[2], middle[1]},
                                   {t[1], middle[0], middle[2]},
                                   {t[2], middle[1], middle[0]},
                                   {middle[0], middle[1], middle[2]}});
    }
    triangles = std::move(finer);
    return rule;
}

std::vector<Vec3> applied(const Refinement& rule, const std::vector<Vec3>& values) {
    std::vector<Vec3> result(rule.offset.size() - 1, Vec3::Zero());
    for (std::size_t n = 0; n < result.size(); ++n) {
        for (int i = rule.offset[n]; i < rule.offset[n + 1]; ++i) {
            result[n] += rule.weight[i] * values[rule.node[i]];
        }
    }
    return result;
}

}  // namespace

std::vector<SheetEdge> edges_of(const std::vector<std::array<int, 3>>& triangles) {
    std::vector<SheetEdge> all;
    for (const std::array<int, 3>& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
            all.push_back({low, high, t[k], -1});
        }
    }
    std::sort(all.begin(), all.end(), [](const SheetEdge& a, const SheetEdge& b) {
        return std::array{a.from, a.to, a.left} < std::array{b.from, b.to, b.left};
    });
    std::vector<SheetEdge> edges;
    for (const SheetEdge& edge : all) {
        if (!edges.empty() && edges.back().from == edge.from && edges.back().to == edge.to) {
            edges.back().right = edge.left;
        } else {
            edges.push_back(edge);
        }
    }
    return edges;
}

SmoothSheet::SmoothSheet(std::shared_ptr<const MembraneSheet> sheet)
    : sheet_(std::move(sheet)), triangles_(sheet_->mesh.triangles) {
    int nodes = static_cast<int>(sheet_->mesh.nodes.size());
    for (int level = 0; level < level_count && static_cast<int>(triangles_.size()) < most_triangles / 4; ++level) {
        levels_.push_back(refine(triangles_, nodes));
        nodes = static_cast<int>(levels_.back().offset.size()) - 1;
    }
    rest_ = refined(sheet_->mesh.nodes);
    find_edges();
}

std::vector<Vec3> SmoothSheet::refined(const std::vector<Vec3>& at_coarse_nodes) const {
    std::vector<Vec3> values = at_coarse_nodes;
    for (const Refinement& level : levels_) {
        values = applied(level, values);
    }
    return values;
}

void SmoothSheet::find_edges() {
    double outermost = 0.0;
    for (const Vec3& node : rest_) {
        outermost = std::max(outermost, node.head<2>().norm());
    }
    for (const SheetEdge& edge : edges_of(triangles_)) {
        const double rho = 0.5 * (rest_[edge.from] + rest_[edge.to]).head<2>().norm();
        if (edge.right >= 0 || rho < 0.97 * outermost) {
            edges_.push_back(edge);
        }
    }
}

}  // namespace rhexis
