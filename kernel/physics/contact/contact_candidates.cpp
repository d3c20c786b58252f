// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/contact_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/longest.hpp"
#include "physics/contact/near_points.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

namespace {

// Stiffness of a contact in units of what the tissue at the vertex offers. A shorter step makes everything stiffer, so
// the contact may be, up to `stiffest`, where it passes for rigid; at longer steps the solver's work decides. What that
// leaves out, the contact carries over from step to step: at rest all are as stiff as the stiffest.
constexpr double tool_factor = 10.0;  ///< at reference_step
constexpr double wall_factor = 5.0;   ///< bags and planes: wide contacts at low pressure
constexpr double stiffest = 100.0;
constexpr double reference_step = 0.01;  ///< [s]

// Most of its force that a contact may carry over. A body that is light against its contacts follows them within a
// step. One that swings on them gains from step to step what is carried over too late: stable up to two thirds.
constexpr double most_swinging = 0.6;
constexpr double least_following = 4.0;  ///< stiffness of all contacts times dt^2 over the body's mass

constexpr double apart = 5e-3;         ///< a candidate with a larger gap than this needs no anchor [mm]
constexpr double sunk = 0.1;           ///< [mm]
constexpr double resolved = 0.38;      ///< radius of the thinnest part that cannot slip between vertices, in their size
constexpr double point_margin = 0.05;  ///< material points are sought this far beyond what tools move in a step [mm]
constexpr double candidate_reach = 0.2;  ///< candidates are sought this far beyond what can move in a step [mm]

/// A partner with what the search needs to know of it.
struct Partner {
    ContactPartner kind = ContactPartner::tool;
    int index = 0;
    double friction = 0.0;
    Pose pose;      ///< at the start of the step
    Box box;        ///< tools: only vertices inside count
    double margin;  ///< bags and planes: only vertices nearer than this count [mm]
};

std::vector<Partner> partners_of(const WorldModel& model, const WorldState& state, std::span<const ToolState> tools,
                                 double moved, double least_radius, const Box& solid) {
    std::vector<Partner> partners;
    double pushed = moved;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present) {
            continue;
        }
        Partner partner{ContactPartner::tool,
                        static_cast<int>(i),
                        model.tools[i].friction,
                        tools[i].previous_pose,
                        swept_box(model.tools[i], tools[i]),
                        0.0};
        const double thicker = std::max(0.0, least_radius - thinnest(model.tools[i]));
        const double around = moved + thicker + (state.tips[i].hold > 0.0 ? kept_seal : candidate_reach);
        partner.box.low -= Vec3::Constant(around);
        partner.box.high += Vec3::Constant(around);
        if ((partner.box.low.array() > solid.high.array()).any() ||
            (partner.box.high.array() < solid.low.array()).any()) {
            continue;
        }
        partners.push_back(partner);
        pushed += travel(model.tools[i], tools[i]);
    }
    for (std::size_t i = 0; i < model.bags.size(); ++i) {
        partners.push_back({ContactPartner::bag,
                            static_cast<int>(i),
                            model.bags[i].friction,
                            state.bags[i].pose,
                            {},
                            candidate_reach + pushed});
    }
    for (std::size_t i = 0; i < model.planes.size(); ++i) {
        partners.push_back({ContactPartner::plane,
                            static_cast<int>(i),
                            model.planes[i].friction,
                            Pose{},
                            {},
                            candidate_reach + pushed});
    }
    for (std::size_t i = 0; i < model.domes.size(); ++i) {
        partners.push_back(
            {ContactPartner::dome, static_cast<int>(i), model.domes[i].friction, Pose{}, {}, candidate_reach + pushed});
    }
    return partners;
}

double stiffness_factor(ContactPartner partner, double dt) {
    return std::min(stiffest, (partner == ContactPartner::tool ? tool_factor : wall_factor) * reference_step / dt);
}

std::tuple<int, int, ContactPartner, int> key(const ContactMemory& memory) {
    return {memory.solid, memory.vertex, memory.partner, memory.partner_index};
}

/// Takes over the anchor of a contact that touched at the end of the last step.
void recall(const std::vector<ContactMemory>& memory, int solid, int vertex, ContactCandidate& candidate) {
    ContactMemory wanted;
    wanted.solid = solid;
    wanted.vertex = vertex;
    wanted.partner = candidate.partner;
    wanted.partner_index = candidate.index;
    const std::vector<ContactMemory>::const_iterator found =
        std::lower_bound(memory.begin(), memory.end(), wanted,
                         [](const ContactMemory& a, const ContactMemory& b) { return key(a) < key(b); });
    if (found != memory.end() && key(*found) == key(wanted)) {
        candidate.anchor = found->anchor;
        candidate.force = found->force;
        candidate.touching = true;
    }
}

ContactCandidate candidate_of(const ContactPoint& point, const Partner& partner, double least_radius) {
    ContactCandidate candidate;
    candidate.at = point;
    candidate.partner = partner.kind;
    candidate.index = partner.index;
    candidate.spring.friction = partner.friction;
    candidate.approach.least_radius = least_radius;
    return candidate;
}

/// How a candidate lies to its partner at the start of the step, and what it remembers.
void begin(const WorldState& state, int solid, const Vec3& local, const SurfaceDistance& start,
           ContactCandidate& candidate) {
    candidate.start = local;
    candidate.start_gap = start.distance;
    candidate.normal = start.normal;
    candidate.anchor = candidate.start;
    recall(state.memory, solid, candidate.at.id, candidate);
}

/// Distance before the mouth of a tool at which a candidate lies, by its gap; infinite if it lies elsewhere.
double before_mouth(const ContactCandidate& candidate, int tool, const Mouth& mouth, double radius) {
    if (candidate.partner != ContactPartner::tool || candidate.index != tool) {
        return HUGE_VAL;
    }
    const Vec3 from_mouth = candidate.start - mouth.centre;
    const double along = mouth.facing.dot(from_mouth);
    const bool before = along > -seal && from_mouth.squaredNorm() - along * along < radius * radius;
    return before ? candidate.start_gap : HUGE_VAL;
}

/// Suction holds what lies before the mouth and nearest to it, each vertex by the same part.
void share_suction(const WorldModel& model, const WorldState& state, std::span<const ToolState> tools,
                   ContactCandidates& candidates) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const double hold = hold_of_lens(state.tips[i]);
        if (!(hold > 0.0)) {
            continue;
        }
        const Mouth mouth = tip_mouth(model.tools[i]);
        const double radius = model.tools[i].bore_radius + seal;
        double farthest = kept_seal - seal;
        for (const ContactCandidate& candidate : candidates) {
            farthest = std::min(farthest, before_mouth(candidate, static_cast<int>(i), mouth, radius));
        }
        farthest = std::max(0.0, farthest) + seal;
        const auto held = [&](const ContactCandidate& candidate) {
            return before_mouth(candidate, static_cast<int>(i), mouth, radius) < farthest;
        };
        const double count = static_cast<double>(std::count_if(candidates.begin(), candidates.end(), held));
        for (ContactCandidate& candidate : candidates) {
            if (held(candidate)) {
                candidate.hold = hold / count;
            }
        }
    }
}

/// Cortex that still adheres to the capsule bears pull and shear over the area of its vertex; where it came off, what
/// stays behind bears a little shear.
void set_adhesion(const WorldModel& model, const WorldState& state, const ContactSurface& surface,
                  ContactCandidates& candidates) {
    for (ContactCandidate& candidate : candidates) {
        if (candidate.partner != ContactPartner::bag || !is_node(candidate.at)) {
            continue;
        }
        const BagModel& bag = model.bags[candidate.index];
        const double area = candidate.at.size * candidate.at.size;
        candidate.grip = surface.in_pieces() ? 0.0 : bag.film * area;  // fluid gets between the pieces and the capsule
        const std::vector<std::uint8_t>& adherent = state.bags[candidate.index].adherent;
        if (!adherent.empty() && adherent[candidate.at.nodes[0]] != 0) {
            candidate.hold = bag.adhesion * area;
            candidate.grip = candidate.hold;
        }
    }
}

/// Candidates of material points with the tools that come near; `box` is around the solid.
void add_points(const WorldModel& world, int solid, const ContactSurface& surface, const WorldState& state,
                std::span<const ToolState> tools, double dt, const std::vector<Partner>& partners, const Box& box,
                ContactCandidates& candidates) {
    std::vector<ToolReach> reaches;
    std::vector<const Partner*> of_reach;
    for (const Partner& partner : partners) {
        if (partner.kind == ContactPartner::tool) {
            const ToolModel& tool = world.tools[partner.index];
            const double travelled = travel_near(tool, tools[partner.index], box);
            ToolReach reach{&tool, partner.pose, travelled + point_margin};
            if (state.tips[partner.index].hold > 0.0) {
                reach.mouth = tip_mouth(tool).centre;
                reach.mouth_radius = tool.bore_radius + seal + kept_seal + travelled;
                reach.mouth_margin = travelled + kept_seal;
            }
            reaches.push_back(reach);
            of_reach.push_back(&partner);
        }
    }
    std::vector<NearPoint> points;
    find_near_points(world.solids[solid], surface.point_spacings(), state.solids[solid], reaches, dt, points);
    for (const NearPoint& near : points) {
        const Partner& partner = *of_reach[static_cast<std::size_t>(near.reach)];
        const Vec3 point = point_of(near.at, state.solids[solid].position);
        ContactCandidate candidate = candidate_of(near.at, partner, resolved_by_points * near.at.size);
        const SurfaceDistance start = measure_gap(world, candidate, partner.pose, point);
        begin(state, solid, partner.pose.to_body(point), start, candidate);
        candidates.push_back(candidate);
    }
}

/// Beyond the wall by more than contact ever lets a point sink in: it left through the opening.
bool left_bag(const Partner& partner, const Vec3& point, const SurfaceDistance& gap) {
    return partner.kind == ContactPartner::bag && gap.distance < -sunk && partner.pose.to_body(point).z() > -sunk;
}

/// How far beyond a bag's wall it still pushes back: without a hole there is no other way to get there than through it.
double wall_reach(const WorldState& state) {
    return state.capsule && state.capsule->hole_radius > 0.0 ? bag_wall : HUGE_VAL;
}

/// Behind a hole there is no wall to touch.
bool over_hole(const WorldState& state, ContactPartner partner, const Vec3& local) {
    return partner == ContactPartner::bag && state.capsule && within_hole(*state.capsule, local);
}

}  // namespace

Pose PartnerPoses::of(ContactPartner partner, int index) const {
    switch (partner) {
        case ContactPartner::tool:
            return tools[index];
        case ContactPartner::bag:
            return bags[index];
        case ContactPartner::plane:
        case ContactPartner::support:
        case ContactPartner::dome:
        case ContactPartner::tube:
        case ContactPartner::layer:
        case ContactPartner::sheet:
        case ContactPartner::jaws:
            break;
    }
    return Pose{};
}

void place_tools(std::span<const ToolState> tools, double s, PartnerPoses& poses) {
    poses.tools.resize(tools.size());
    for (std::size_t i = 0; i < tools.size(); ++i) {
        poses.tools[i] = pose_within(tools[i], s);
    }
}

SurfaceDistance measure_gap(const WorldModel& model, const ContactCandidate& candidate, const Pose& pose,
                            const Vec3& point) {
    SurfaceDistance gap =
        distance_to(rigid_partners(model), candidate.partner, candidate.index, pose, point, candidate.approach);
    gap.distance -= candidate.at.radius;
    return gap;
}

bool surely_apart(const ContactCandidate& candidate, const Pose& pose, const Vec3& point) {
    // The gap changes by no more than the point moves in the partner's frame.
    const double slack = candidate.start_gap - apart;
    return slack > 0.0 && (pose.to_body(point) - candidate.start).squaredNorm() < slack * slack;
}

void find_candidates(const WorldModel& model, int solid, const WorldState& state, std::span<const ToolState> tools,
                     double dt, const ContactSurface& surface, ContactCandidates& candidates) {
    candidates.clear();
    const std::vector<Vec3>& nodes = state.solids[solid].position;
    Box box;
    double largest = 0.0;
    for (const SurfaceVertex& vertex : surface.vertices()) {
        box.add(point_of(vertex, nodes), 0.0);
        largest = std::max(largest, vertex.size);
    }
    const double moved = 2.0 * longest(state.solids[solid].velocity) * dt;
    const std::vector<Partner> partners = partners_of(model, state, tools, moved, resolved * largest, box);
    const double wall = wall_reach(state);
    const bool by_points = model.solids[solid].by_points && !model.solids[solid].fine.tets.empty();
    for (std::size_t v = 0; v < surface.vertices().size(); ++v) {
        const SurfaceVertex& vertex = surface.vertices()[v];
        const Vec3 point = point_of(vertex, nodes);
        for (const Partner& partner : partners) {
            const bool tool = partner.kind == ContactPartner::tool;
            // Inside a convex wall, the middle of two points is inside if they are.
            if (tool ? by_points || !partner.box.holds(point) : vertex.between) {
                continue;
            }
            ContactCandidate candidate = candidate_of(contact_point(vertex), partner, resolved * vertex.size);
            candidate.approach.wall = wall;
            SurfaceDistance start = measure_gap(model, candidate, partner.pose, point);
            candidate.approach.outside = left_bag(partner, point, start);
            if (candidate.approach.outside) {
                start = measure_gap(model, candidate, partner.pose, point);
            }
            if (!tool && start.distance > partner.margin) {
                continue;
            }
            const Vec3 local = partner.pose.to_body(point);
            if (over_hole(state, partner.kind, local)) {
                continue;
            }
            begin(state, solid, local, start, candidate);
            candidates.push_back(candidate);
        }
    }
    if (by_points) {
        add_points(model, solid, surface, state, tools, dt, partners, box, candidates);
    }
    share_suction(model, state, tools, candidates);
    set_adhesion(model, state, surface, candidates);
}

void break_adhesion(const ContactCandidates& candidates, std::vector<BagState>& bags) {
    for (const ContactCandidate& candidate : candidates) {
        if (candidate.hold > 0.0 && candidate.partner == ContactPartner::bag && candidate.sliding) {
            bags[candidate.index].adherent[candidate.at.nodes[0]] = 0;
        }
    }
}

void set_springs(double dt, double mass, ContactCandidates& candidates) {
    double all = 0.0;
    for (ContactCandidate& candidate : candidates) {
        const double factor = stiffness_factor(candidate.partner, dt);
        candidate.spring.stiffness = factor * candidate.at.stiffness;
        candidate.carry = 1.0 - factor / stiffest;
        all += candidate.touching ? candidate.spring.stiffness : 0.0;
    }
    if (!(all * dt * dt > least_following * mass)) {
        for (ContactCandidate& candidate : candidates) {
            candidate.carry = std::min(candidate.carry, most_swinging);
        }
    }
}

void report_contacts(const ContactCandidates& candidates, int solid, double dt, ContactSet& contacts) {
    for (const ContactCandidate& candidate : candidates) {
        if (candidate.impulse.isZero(0.0)) {
            continue;
        }
        Contact contact;
        contact.solid = solid;
        bearing_nodes(candidate.at, contact.nodes, contact.weights);
        contact.partner = candidate.partner;
        contact.partner_index = candidate.index;
        contact.point = candidate.point;
        contact.normal = candidate.normal;
        contact.gap = candidate.gap;
        contact.force = candidate.impulse / dt;
        contact.sliding = candidate.sliding;
        contacts.push_back(contact);
    }
}

void remember_contacts(const ContactCandidates& candidates, int solid, std::vector<ContactMemory>& memory) {
    for (const ContactCandidate& candidate : candidates) {
        if (candidate.touching) {
            memory.push_back(
                {solid, candidate.at.id, candidate.partner, candidate.index, candidate.anchor, candidate.force});
        }
    }
}

}  // namespace rhexis
