// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/sheet_editor.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

/// Local number of a node in a triangle, or -1.
int corner_of(const std::array<int, 3>& triangle, int node) {
    for (int k = 0; k < 3; ++k) {
        if (triangle[at(k)] == node) {
            return k;
        }
    }
    return -1;
}

}  // namespace

SheetEditor::SheetEditor(const MembraneSheet& sheet) : sheet_(&sheet), mesh_(sheet.mesh) {
    parent_.resize(mesh_.triangles.size());
    for (int t = 0; t < static_cast<int>(parent_.size()); ++t) {
        parent_[at(t)] = t;
    }
}

std::vector<int> SheetEditor::star(int node) const {
    std::vector<int> result;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
        if (corner_of(mesh_.triangles[at(t)], node) >= 0) {
            result.push_back(t);
        }
    }
    return result;
}

int SheetEditor::triangle_with(int from, int to) const {
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
        const std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        const int k = corner_of(triangle, from);
        if (k >= 0 && triangle[at((k + 1) % 3)] == to) {
            return t;
        }
    }
    return -1;
}

bool SheetEditor::on_boundary(int node) const {
    for (const int t : star(node)) {
        const std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        const int next = triangle[at((corner_of(triangle, node) + 1) % 3)];
        if (triangle_with(next, node) < 0) {
            return true;
        }
    }
    return false;
}

int SheetEditor::split_edge(int a, int b, double share) {
    const int middle = static_cast<int>(mesh_.nodes.size());
    mesh_.nodes.push_back(mesh_.nodes[at(a)] + share * (mesh_.nodes[at(b)] - mesh_.nodes[at(a)]));
    nodes_.push_back({a, b, share});
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        const int t = triangle_with(from, to);
        if (t < 0) {
            continue;
        }
        std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        std::array<int, 3> other = triangle;
        other[at(corner_of(other, from))] = middle;
        triangle[at(corner_of(triangle, to))] = middle;
        mesh_.triangles.push_back(other);
        parent_.push_back(parent_[at(t)]);
    }
    return middle;
}

std::vector<int> SheetEditor::right_of(int node, int first, int stop) const {
    std::vector<int> fan;
    int t = triangle_with(first, node);
    while (t >= 0) {
        fan.push_back(t);
        const std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        const int next = triangle[at((corner_of(triangle, node) + 1) % 3)];
        t = next == stop || next == first ? -1 : triangle_with(next, node);
    }
    return fan;
}

std::vector<int> SheetEditor::right_before(int node, int last) const {
    std::vector<int> fan;
    int t = triangle_with(node, last);
    while (t >= 0) {
        fan.push_back(t);
        const std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        const int before = triangle[at((corner_of(triangle, node) + 2) % 3)];
        t = before == last ? -1 : triangle_with(node, before);
    }
    return fan;
}

int SheetEditor::copy(int node) {
    mesh_.nodes.push_back(Vec3(mesh_.nodes[at(node)]));
    nodes_.push_back({node, node, 0.0});
    return static_cast<int>(mesh_.nodes.size()) - 1;
}

void SheetEditor::replace(const std::vector<int>& triangles, int node, int by) {
    for (const int t : triangles) {
        std::array<int, 3>& triangle = mesh_.triangles[at(t)];
        triangle[at(corner_of(triangle, node))] = by;
    }
}

void SheetEditor::open_edge(int from, int to) {
    RHEXIS_ASSERT(triangle_with(from, to) >= 0 && triangle_with(to, from) >= 0);
    const bool ends = on_boundary(to);
    const std::vector<int> right = right_of(from, to, -1);
    const std::vector<int> beyond = ends ? right_before(to, from) : std::vector<int>{};
    replace(right, from, copy(from));
    if (ends) {
        replace(beyond, to, copy(to));
    }
}

void SheetEditor::open_slit(int from, int to, int middle) {
    const bool from_ends = on_boundary(from);
    const bool to_ends = on_boundary(to);
    // to the right of from -> middle -> to
    const std::vector<int> right = right_of(middle, to, from);
    const std::vector<int> at_to = to_ends ? right_before(to, middle) : std::vector<int>{};
    const std::vector<int> at_from = from_ends ? right_of(from, middle, -1) : std::vector<int>{};
    replace(right, middle, copy(middle));
    if (to_ends) {
        replace(at_to, to, copy(to));
    }
    if (from_ends) {
        replace(at_from, from, copy(from));
    }
}

double SheetEditor::thickness_along(int a, int b) const {
    double sum = 0.0;
    int count = 0;
    for (const int t : {triangle_with(a, b), triangle_with(b, a)}) {
        if (t >= 0) {
            sum += sheet_->thickness[at(parent_[at(t)])];
            ++count;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

MembraneEdit SheetEditor::edit() const {
    MembraneEdit edit;
    edit.nodes = nodes_;
    const int before = static_cast<int>(sheet_->mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
        if (t >= before || mesh_.triangles[at(t)] != sheet_->mesh.triangles[at(t)]) {
            edit.triangles.push_back({t < before ? t : -1, mesh_.triangles[at(t)], parent_[at(t)]});
        }
    }
    return edit;
}

}  // namespace rhexis
