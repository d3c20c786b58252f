// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/sheet_accounts.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "topology/tear.hpp"

namespace rhexis::scenes {
namespace {

double mass_of(const MembraneModel& model, const MembraneSheet& sheet) {
    double mass = 0.0;
    for (std::size_t t = 0; t < sheet.mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = sheet.mesh.triangles[t];
        mass += model.density * sheet.thickness[t] *
                triangle_area(sheet.mesh.nodes[at(n[0])], sheet.mesh.nodes[at(n[1])], sheet.mesh.nodes[at(n[2])]);
    }
    return mass;
}

/// Length times thickness of all free edges.
double rim_of(const MembraneSheet& sheet) {
    double rim = 0.0;
    for (std::size_t t = 0; t < sheet.mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (sheet.neighbours.across[t][k] < 0) {
                const std::array<int, 3>& n = sheet.mesh.triangles[t];
                rim += sheet.thickness[t] *
                       (sheet.mesh.nodes[at(n[(k + 1) % 3])] - sheet.mesh.nodes[at(n[(k + 2) % 3])]).norm();
            }
        }
    }
    return rim;
}

double cosine_of(const TriMesh& mesh) {
    double most = -1.0;
    for (const std::array<int, 3>& n : mesh.triangles) {
        most = std::max(most, largest_cosine(mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])]));
    }
    return most;
}

double shortest_edge(const TriMesh& mesh) {
    double least = HUGE_VAL;
    for (const std::array<int, 3>& n : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            least = std::min(least, (mesh.nodes[at(n[k])] - mesh.nodes[at(n[(k + 1) % 3])]).norm());
        }
    }
    return least;
}

double off(double found, double expected) { return std::abs(found - expected) / std::abs(expected); }

/// Weights of a place as those of a triangle's corners, seen along z.
Vec3 weights_in(const TriMesh& mesh, std::size_t triangle, const Vec3& place) {
    const std::array<int, 3>& n = mesh.triangles[triangle];
    const auto area = [](const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).z(); };
    const Vec3& a = mesh.nodes[at(n[0])];
    const Vec3& b = mesh.nodes[at(n[1])];
    const Vec3& c = mesh.nodes[at(n[2])];
    return Vec3(area(b, c, place), area(c, a, place), area(a, b, place)) / area(a, b, c);
}

}  // namespace

int inner_edges(const MembraneSheet& sheet) {
    int sides = 0;
    for (const std::array<int, 3>& across : sheet.neighbours.across) {
        sides += static_cast<int>(std::count_if(across.begin(), across.end(), [](int t) { return t >= 0; }));
    }
    return sides / 2;
}

SheetAccounts::SheetAccounts(const MembraneModel& model)
    : model_(&model),
      area_(mesh_area(model.sheet->mesh)),
      mass_(mass_of(model, *model.sheet)),
      rim_(rim_of(*model.sheet)),
      most_cosine_(std::max(TearRules{}.most_cosine, cosine_of(model.sheet->mesh))),
      mean_edge_(mean_edge(model.sheet->mesh)) {
    const double shortest = TearRules{}.shortest_edge * mean_edge_;
    bound_ = static_cast<double>(model.sheet->mesh.triangles.size()) + 4.0 * area_ / (shortest * shortest);
}

std::string SheetAccounts::motion_fault(const MembraneState& state) const {
    const auto bad = [](const Vec3& x) { return !x.allFinite(); };
    if (std::any_of(state.position.begin(), state.position.end(), bad) ||
        std::any_of(state.velocity.begin(), state.velocity.end(), bad)) {
        return "a position or velocity is no number";
    }
    const int nodes = static_cast<int>(state.position.size());
    for (const SheetGrip& grip : state.grips) {
        if (grip.node < 0 || grip.node >= nodes || !grip.place.allFinite()) {
            return "a grip holds node " + std::to_string(grip.node) + " of " + std::to_string(nodes);
        }
    }
    return {};
}

/// What connects things.
std::string SheetAccounts::sheet_fault(const MembraneState& state) const {
    const MembraneSheet& sheet = *state.sheet;
    const UnusedNodes unused = state.area_out > 0.0 ? UnusedNodes::allowed : UnusedNodes::refused;
    if (Status status = validate_tri_mesh(sheet.mesh, {}, unused); !status) {
        return status.error().text();
    }
    const std::size_t triangles = sheet.mesh.triangles.size();
    const std::size_t nodes = sheet.mesh.nodes.size();
    if (sheet.fibre.size() != triangles || sheet.thickness.size() != triangles || sheet.stiffness.size() != triangles ||
        sheet.origin.size() != nodes || state.position.size() != nodes || state.velocity.size() != nodes) {
        return "a list is of another length than the mesh";
    }
    const std::vector<std::uint8_t> edge = on_boundary(sheet.mesh, sheet.neighbours);
    for (const TearTip& tip : state.tips) {
        if (tip.node < 0 || tip.node >= static_cast<int>(nodes) || edge[at(tip.node)] == 0 ||
            !(std::abs(tip.direction.norm() - 1.0) < 1e-9) || !tip.owed.allFinite()) {
            return "tip at node " + std::to_string(tip.node) + " is no end of a tear";
        }
    }
    return motion_fault(state);
}

std::string SheetAccounts::taken_out_fault(const MembraneState& state) const {
    if (const std::string fault = sheet_fault(state); !fault.empty()) {
        return fault;
    }
    const double both = mesh_area(state.sheet->mesh) + state.area_out;
    return off(both, area_) < 1e-12 ? std::string() : "what is left and what was taken out are not all of it";
}

std::string SheetAccounts::look(const MembraneState& state, RandomTears& found) const {
    if (const std::string fault = sheet_fault(state); !fault.empty()) {
        return fault;
    }
    const MembraneSheet& sheet = *state.sheet;
    const int triangles = static_cast<int>(sheet.mesh.triangles.size());
    const int nodes = static_cast<int>(sheet.mesh.nodes.size());
    const double cosine = cosine_of(sheet.mesh);
    found.most_cosine = std::max(found.most_cosine, cosine - most_cosine_);
    found.least_angle = std::min(found.least_angle, std::acos(std::min(1.0, cosine)) * 180.0 / M_PI);
    found.least_edge = std::min(found.least_edge, shortest_edge(sheet.mesh) / mean_edge_);
    found.most_triangles = std::max(found.most_triangles, triangles);
    found.most_nodes = std::max(found.most_nodes, nodes);
    found.most_of_bound = std::max(found.most_of_bound, triangles / bound_);
    found.most_per_triangle = std::max(found.most_per_triangle, static_cast<double>(nodes) / triangles);
    found.area_off = std::max(found.area_off, off(mesh_area(sheet.mesh), area_));
    found.mass_off = std::max(found.mass_off, off(mass_of(*model_, sheet), mass_));
    found.torn_off = std::max(found.torn_off, off(state.torn_area, 0.5 * (rim_of(sheet) - rim_)));
    // of fibres only the range is known without the way of every edge
    const auto [least, most] = std::minmax(model_->toughness.along, model_->toughness.across);
    const double low = least * state.torn_area;
    const double high = most * state.torn_area;
    const double beyond = std::max({0.0, low - state.torn_energy, state.torn_energy - high});
    found.energy_off = std::max(found.energy_off, beyond / low);
    return {};
}

std::string SheetAccounts::descent_fault(const MembraneState& state) const {
    const MembraneSheet& start = *model_->sheet;
    const MembraneSheet& now = *state.sheet;
    for (std::size_t t = 0; t < now.mesh.triangles.size(); ++t) {
        const Vec3 middle = triangle_middle(now.mesh, static_cast<int>(t));
        bool found = false;
        for (std::size_t s = 0; s < start.mesh.triangles.size() && !found; ++s) {
            found = weights_in(start.mesh, s, middle).minCoeff() > -1e-9 && now.thickness[t] == start.thickness[s] &&
                    now.stiffness[t] == start.stiffness[s] && now.fibre[t] == start.fibre[s];
        }
        if (!found) {
            return "triangle " + std::to_string(t) + " is made of something else than what it was torn from";
        }
    }
    return {};
}

}  // namespace rhexis::scenes
