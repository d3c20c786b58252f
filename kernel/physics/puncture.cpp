// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/puncture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rhexis {
namespace {

constexpr double end_length =
    0.25;  ///< of a needle: what presses so near to its point is pierced, so near to a tip cuts [mm]

constexpr double inside = 0.1;       ///< of a triangle, as weights of its corners: a needle there is through it
constexpr double longest_cut = 0.8;  ///< from the end of a tear to a needle that goes on with it [mm]

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

struct SheetPlace {
    int triangle = 0;
    Vec3 rest = Vec3::Zero();  ///< [mm]
};

/// Where a needle from its point `a` to `b` goes through the sheet, nearest to its point.
std::optional<SheetPlace> where_through(const MembraneState& state, const Vec3& a, const Vec3& b) {
    std::optional<SheetPlace> found;
    double nearest = 1.0;
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[at(t)];
        const Vec3& x = state.position[at(n[0])];
        if ((x - a).squaredNorm() > 4.0) {
            continue;
        }
        // a + s (b - a) = x + u e1 + v e2
        Mat3 sides;
        sides << state.position[at(n[1])] - x, state.position[at(n[2])] - x, a - b;
        const double volume = sides.determinant();
        if (!(std::abs(volume) > 1e-9)) {
            continue;
        }
        const Vec3 uvs = sides.inverse() * (a - x);
        const double least = std::min({uvs[0], uvs[1], 1.0 - uvs[0] - uvs[1]});
        if (least > inside && uvs[2] > 0.0 && uvs[2] < nearest) {
            nearest = uvs[2];
            const std::vector<Vec3>& rest = state.sheet->mesh.nodes;
            found = SheetPlace{t, rest[at(n[0])] + uvs[0] * (rest[at(n[1])] - rest[at(n[0])]) +
                                      uvs[1] * (rest[at(n[2])] - rest[at(n[0])])};
        }
    }
    return found;
}

/// Of a tear that a needle at a place at rest would lengthen; -1: none is near.
int nearest_tip(const MembraneState& state, const Vec3& place) {
    int nearest = -1;
    double least = longest_cut;
    for (int i = 0; i < static_cast<int>(state.tips.size()); ++i) {
        const TearTip& tip = state.tips[at(i)];
        const Vec3 way = place - state.sheet->mesh.nodes[at(tip.node)];
        if (way.norm() < least && way.norm() > 1e-6 && way.dot(tip.direction) > 0.0) {
            least = way.norm();
            nearest = i;
        }
    }
    return nearest;
}

}  // namespace

std::vector<PunctureProposal> propose_punctures(const WorldModel& world, int membrane, const MembraneState& state,
                                                std::span<const ToolState> tools, const ContactSet& contacts) {
    std::vector<PunctureProposal> proposals;
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        if (world.tools[at(k)].kind != ToolKind::cystotome || !tools[at(k)].present) {
            continue;
        }
        Vec3 force = Vec3::Zero();
        const Contact* hardest = nullptr;
        for (const Contact& contact : contacts) {
            const bool own = contact.membrane == membrane && contact.partner == ContactPartner::tool &&
                             contact.partner_index == k && contact.nodes[2] >= 0;
            if (own && tools[at(k)].pose.to_body(contact.point).norm() < end_length) {
                force += contact.force;
                const bool harder = hardest == nullptr || contact.force.norm() > hardest->force.norm();
                hardest = harder ? &contact : hardest;
            }
        }
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

void propose_cuts(const WorldModel& world, const MembraneState& state, std::span<const ToolState> tools,
                  MembraneStepReport& report) {
    for (std::size_t k = 0; k < tools.size(); ++k) {
        if (world.tools[k].kind != ToolKind::cystotome || !tools[k].present) {
            continue;
        }
        const std::optional<SheetPlace> place =
            where_through(state, tools[k].pose.position, tools[k].pose.to_world(world.tools[k].parts[0].b));
        if (!place) {
            continue;
        }
        const int tip = nearest_tip(state, place->rest);
        if (tip < 0) {
            const Vec3 edge = at_rest(state, state.sheet->mesh.triangles[at(place->triangle)],
                                      tools[k].pose.orientation * Vec3::UnitX());
            report.punctures.push_back({place->triangle, place->rest, edge});
            continue;
        }
        std::erase_if(report.tears, [tip](const TearProposal& other) { return other.tip == tip; });
        const Vec3 way = place->rest - state.sheet->mesh.nodes[at(state.tips[at(tip)].node)];
        report.tears.push_back({tip, way.normalized(), 0.0, 0.0});
    }
}

std::vector<double> cutting_at_tips(const WorldModel& world, int membrane, const MembraneState& state,
                                    const ContactSet& contacts) {
    std::vector<double> shares(state.tips.size(), 1.0);
    for (const Contact& contact : contacts) {
        if (contact.membrane != membrane || contact.partner != ContactPartner::tool) {
            continue;
        }
        for (std::size_t i = 0; i < shares.size(); ++i) {
            if ((state.position[at(state.tips[i].node)] - contact.point).norm() < end_length) {
                shares[i] = std::min(shares[i], world.tools[at(contact.partner_index)].cutting);
            }
        }
    }
    return shares;
}

}  // namespace rhexis
