// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/puncture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/index.hpp"
#include "physics/membrane/needle.hpp"

namespace rhexis {
namespace {

constexpr double end_length = 0.25;  ///< of a needle: what presses so near to its point is pierced [mm]

/// The triangle with these corners, or -1.
int triangle_of(const MembraneSheet& sheet, const std::array<int, 3>& nodes) {
    const auto& triangles = sheet.mesh.triangles;
    const auto found = std::find(triangles.begin(), triangles.end(), nodes);
    return found == triangles.end() ? -1 : static_cast<int>(found - triangles.begin());
}

/// A direction now, as it lies in the sheet at rest: the same combination of two edges of the triangle.
Vec3 at_rest(const MembraneState& state, const std::array<int, 3>& n, const Vec3& direction) {
    const auto edge = [&n](const std::vector<Vec3>& of, std::size_t k) { return Vec3(of[at(n[k])] - of[at(n[0])]); };
    const Vec3 a = edge(state.position, 1);
    const Vec3 b = edge(state.position, 2);
    Eigen::Matrix2d gram;
    gram << a.dot(a), a.dot(b), a.dot(b), b.dot(b);
    if (!(gram.determinant() > 1e-12 * gram.trace() * gram.trace())) {
        return Vec3::Zero();  // crushed to a line
    }
    const Vec2 share = gram.inverse() * Vec2(a.dot(direction), b.dot(direction));
    const std::vector<Vec3>& rest = state.sheet->mesh.nodes;
    return share.x() * edge(rest, 1) + share.y() * edge(rest, 2);
}

/// What a tool does to a membrane by those of its contacts that count.
struct Press {
    Vec3 force = Vec3::Zero();         ///< summed [uN]
    const Contact* hardest = nullptr;  ///< null: there is none
};

template <typename Counts>
Press press_of(int tool, int membrane, const ContactSet& contacts, const Counts& counts) {
    Press press;
    for (const Contact& contact : contacts) {
        if (contact.membrane == membrane && contact.partner == ContactPartner::tool && contact.partner_index == tool &&
            counts(contact)) {
            press.force += contact.force;
            const bool harder = press.hardest == nullptr || contact.force.norm() > press.hardest->force.norm();
            press.hardest = harder ? &contact : press.hardest;
        }
    }
    return press;
}

/// Where a needle's axis meets the sheet that it dents.
std::optional<SheetPlace> under_point(const MembraneState& state, const Pose& pose) {
    return where_through(state, pose.to_world(-end_length * Vec3::UnitZ()), pose.to_world(end_length * Vec3::UnitZ()));
}

/// Where a cut from a node goes: to the place of the sheet where the needle stands; where that is an opening, the way
/// in which it pushes. In the sheet at rest.
Vec3 way_of_cut(const ToolModel& needle, const Pose& pose, const MembraneState& state, int node, int triangle,
                const Vec3& push) {
    constexpr double too_near = 0.02;  // to tell a direction [mm]
    const std::optional<SheetPlace> through = where_through(state, pose.position, pose.to_world(needle.parts[0].b));
    if (through) {
        Vec3 way = through->rest - state.sheet->mesh.nodes[at(node)];
        if (way.norm() > too_near) {
            return way;
        }
    }
    return at_rest(state, state.sheet->mesh.triangles[at(triangle)], push);
}

bool is_needle(const WorldModel& world, std::span<const ToolState> tools, int tool) {
    return world.tools[at(tool)].kind == ToolKind::cystotome && tools[at(tool)].present;
}

}  // namespace

std::vector<PunctureProposal> propose_punctures(const WorldModel& world, int membrane, const MembraneState& state,
                                                std::span<const ToolState> tools, const ContactSet& contacts) {
    std::vector<PunctureProposal> proposals;
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        if (!is_needle(world, tools, k)) {
            continue;
        }
        const auto [force, hardest] = press_of(k, membrane, contacts, [&](const Contact& contact) {
            return contact.nodes[2] >= 0 && tools[at(k)].pose.to_body(contact.point).norm() < end_length;
        });
        const int triangle = hardest == nullptr ? -1 : triangle_of(*state.sheet, hardest->nodes);
        if (triangle < 0 ||
            force.norm() < world.membranes[at(membrane)].piercing * state.sheet->thickness[at(triangle)]) {
            continue;
        }
        PunctureProposal proposal;
        proposal.triangle = triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            proposal.place += hardest->weights[i] * state.sheet->mesh.nodes[at(hardest->nodes[i])];
        }
        if (const std::optional<SheetPlace> under = under_point(state, tools[at(k)].pose)) {
            proposal.triangle = under->triangle;  // its round end may press hardest a little to one side
            proposal.place = under->rest;
        }
        proposal.direction = at_rest(state, hardest->nodes, tools[at(k)].pose.orientation * Vec3::UnitX());
        proposals.push_back(proposal);
    }
    return proposals;
}

std::vector<CutProposal> propose_cuts(const WorldModel& world, int membrane, const MembraneState& state,
                                      std::span<const ToolState> tools, const ContactSet& contacts) {
    std::vector<CutProposal> proposals;
    const MembraneModel& model = world.membranes[at(membrane)];
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        if (!is_needle(world, tools, k)) {
            continue;
        }
        // what a needle pushes are single nodes, of one lip
        const auto [force, hardest] =
            press_of(k, membrane, contacts, [](const Contact& contact) { return contact.nodes[1] < 0; });
        if (hardest == nullptr || force.isZero()) {
            continue;
        }
        const int node = hardest->nodes[0];
        const int triangle = state.sheet->neighbours.triangles[at(state.sheet->neighbours.offset[at(node)])];
        const Vec3 push = force.normalized();
        const Vec3 way = way_of_cut(world.tools[at(k)], tools[at(k)].pose, state, node, triangle, push);
        const bool end =
            std::any_of(state.tips.begin(), state.tips.end(), [node](const TearTip& tip) { return tip.node == node; });
        const double share = end ? world.tools[at(k)].cutting : 1.0;
        const double toughness = toughness_along(model.toughness, state.sheet->fibre[at(triangle)], way.normalized());
        if (!way.isZero() && force.norm() > share * toughness * state.sheet->thickness[at(triangle)]) {
            proposals.push_back({k, node, way.normalized()});
        }
    }
    return proposals;
}

}  // namespace rhexis
