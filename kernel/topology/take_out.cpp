// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/take_out.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "base/index.hpp"
#include "topology/tear.hpp"

namespace rhexis {
namespace {

int pieces_of(const std::vector<int>& parts) {
    return parts.empty() ? 0 : 1 + *std::max_element(parts.begin(), parts.end());
}

int largest_of(const std::vector<int>& parts) {
    std::vector<int> size(at(pieces_of(parts)), 0);
    for (const int part : parts) {
        ++size[at(part)];
    }
    return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
}

/// Per piece: whether something holds it.
std::vector<std::uint8_t> held(const MembraneModel& model, const MembraneSheet& sheet, const std::vector<int>& parts) {
    std::vector<std::uint8_t> hangs(sheet.mesh.nodes.size(), 0);
    for (const NodeSpring& spring : model.springs) {
        hangs[at(spring.node)] = 1;
    }
    for (const int node : model.fixed_nodes) {
        hangs[at(node)] = 1;
    }
    std::vector<std::uint8_t> result(at(pieces_of(parts)), 0);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        for (const int node : sheet.mesh.triangles[t]) {
            const int origin = sheet.origin[at(node)];
            if (origin >= 0 && hangs[at(origin)] != 0) {
                result[at(parts[t])] = 1;
            }
        }
    }
    return result;
}

/// Edges of triangle t that nothing lies beyond [mm].
double free_edges(const MembraneSheet& sheet, int t) {
    double sum = 0.0;
    const std::array<int, 3>& n = sheet.mesh.triangles[at(t)];
    for (std::size_t k = 0; k < 3; ++k) {
        if (sheet.neighbours.across[at(t)][k] < 0) {
            sum += (sheet.mesh.nodes[at(n[(k + 1) % 3])] - sheet.mesh.nodes[at(n[(k + 2) % 3])]).norm();
        }
    }
    return sum;
}

template <typename Value>
std::vector<Value> kept(const std::vector<Value>& all, const std::vector<std::uint8_t>& out) {
    std::vector<Value> list;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (out[i] == 0) {
            list.push_back(all[i]);
        }
    }
    return list;
}

}  // namespace

MembraneEdit take_out(const MembraneModel& model, const MembraneState& state, const std::vector<int>& nodes) {
    MembraneEdit edit;
    edit.tips = state.tips;
    if (nodes.empty()) {
        return edit;
    }
    const MembraneSheet& sheet = *state.sheet;
    const std::vector<int> parts = sheet_parts(sheet.neighbours);
    std::vector<std::uint8_t> goes(at(pieces_of(parts)), 0);
    for (const int node : nodes) {
        if (!is_out(sheet, node)) {
            goes[at(parts[at(sheet.neighbours.triangles[at(sheet.neighbours.offset[at(node)])])])] = 1;
        }
    }
    goes[at(largest_of(parts))] = 0;
    const std::vector<std::uint8_t> hangs = held(model, sheet, parts);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        if (goes[at(parts[t])] != 0 && hangs[at(parts[t])] == 0) {
            edit.out.push_back(static_cast<int>(t));
            edit.edge_out += free_edges(sheet, static_cast<int>(t));
            const std::array<int, 3>& n = sheet.mesh.triangles[t];
            edit.area_out +=
                triangle_area(sheet.mesh.nodes[at(n[0])], sheet.mesh.nodes[at(n[1])], sheet.mesh.nodes[at(n[2])]);
        }
    }
    return edit;
}

MembraneState without(const MembraneState& state, const MembraneEdit& edit) {
    MembraneState next = state;
    std::shared_ptr<MembraneSheet> sheet = std::make_shared<MembraneSheet>(*state.sheet);
    std::vector<std::uint8_t> out(sheet->mesh.triangles.size(), 0);
    for (const int t : edit.out) {
        out[at(t)] = 1;
    }
    sheet->mesh.triangles = kept(sheet->mesh.triangles, out);
    sheet->fibre = kept(sheet->fibre, out);
    sheet->thickness = kept(sheet->thickness, out);
    sheet->stiffness = kept(sheet->stiffness, out);
    sheet->neighbours = tri_neighbours(sheet->mesh);
    const auto gone = [&sheet](int node) { return is_out(*sheet, node); };
    std::erase_if(next.tips, [&](const TearTip& tip) { return gone(tip.node); });
    std::erase_if(next.grips, [&](const SheetGrip& grip) { return gone(grip.node); });
    next.touches.clear();  // they name triangles, which have other numbers now: friction starts anew
    for (SheetLoad& load : next.loads) {
        std::erase_if(load.nodes, gone);
    }
    std::erase_if(next.loads, [](const SheetLoad& load) { return load.nodes.empty(); });
    for (std::size_t n = 0; n < next.velocity.size(); ++n) {
        if (gone(static_cast<int>(n))) {
            next.velocity[n].setZero();
        }
    }
    next.edge_out += edit.edge_out;
    next.area_out += edit.area_out;
    next.sheet = std::move(sheet);
    return next;
}

}  // namespace rhexis
