// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/puncture.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

constexpr double end_length = 0.25;  ///< of a needle: what presses so near to its point is pierced [mm]
constexpr double along_edge = 0.7;   ///< cosine from a needle's edge within which that cuts

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
        const Vec3 way = at_rest(state, state.sheet->mesh.triangles[at(triangle)], push);
        const double along = std::abs((tools[at(k)].pose.orientation * Vec3::UnitX()).dot(push));
        const double share = along > along_edge ? world.tools[at(k)].cutting : 1.0;
        const double toughness = toughness_along(model.toughness, state.sheet->fibre[at(triangle)], way.normalized());
        if (!way.isZero() && force.norm() > share * toughness * state.sheet->thickness[at(triangle)]) {
            proposals.push_back({k, node, way.normalized()});
        }
    }
    return proposals;
}

}  // namespace rhexis
