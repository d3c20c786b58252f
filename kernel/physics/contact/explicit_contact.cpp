// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/explicit_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "physics/fluid/mouth.hpp"

namespace rhexis {

namespace {

constexpr int most_sweeps = 3;
constexpr double settled = 0.1;            ///< change of velocity in a sweep that ends them [mm/s]
constexpr double fastest_ejection = 20.0;  ///< at which penetration is undone, so that it throws nothing [mm/s]
constexpr double fastest_push = 5.0;       ///< change of velocity in a substep that no contact may sleep through [mm/s]
constexpr double anchor_pull = 0.2;        ///< share of the drift from the anchor undone in a substep
constexpr double presliding = 1e-4;        ///< of the size of a tetrahedron: a contact keeps its anchor within this
constexpr double spare_arm = 1.0;          ///< that a vertex may come nearer to the end of its arm in a step [mm]
constexpr double longest_arm = 15.0;   ///< for which the motion of partners is noted; longer ones are always looked at
constexpr double spare_motion = 1e-9;  ///< for rounding [mm]
constexpr double flat_square = 3e-5;   ///< (5.5 um)^2: over it a wall of radius 0.8 mm departs from its plane by
                                       ///< 0.02 um [mm^2]

Eigen::Map<const Vec3> row(const double* values, int node) { return Eigen::Map<const Vec3>(values + 4L * node); }
Eigen::Map<Vec3> row(double* values, int node) { return Eigen::Map<Vec3>(values + 4L * node); }

/// New contacts anchor where they are; those that slid drag their anchor behind by no more than the slack. A contact
/// that opens by less than the slack keeps its anchor: a resting body trembles within it and must not creep.
void move_anchor(const Pose& pose, const Vec3& point, const Vec3& normal, bool sliding, bool near, double slack,
                 ContactCandidate& candidate) {
    if (near && !candidate.touching) {
        candidate.anchor = pose.to_body(point);
    } else if (near && sliding) {
        const Vec3 offset = point - pose.to_world(candidate.anchor);
        candidate.anchor = pose.to_body(point - project_on_disc(offset - normal.dot(offset) * normal, slack));
    }
    candidate.touching = near;
}

}  // namespace

void ExplicitContact::begin(const WorldModel& model, const PartnerPoses& poses, ContactCandidates& candidates,
                            const std::vector<PiecePair>& pairs, std::vector<SuctionGrip>& grips,
                            ExplicitSolid& solid) {
    model_ = &model;
    candidates_ = &candidates;
    pairs_ = &pairs;
    grips_ = &grips;
    rows_ = solid.rows();
    drifts_.assign(1, Drift{});
    for (const std::vector<Pose>* partners : {&poses.tools, &poses.bags}) {
        for (const Pose& pose : *partners) {
            drifts_.push_back({pose});
        }
    }
    const int first_bag = 1 + static_cast<int>(poses.tools.size());
    watches_.assign(candidates.size(), Watch{});
    wakes_.assign(candidates.size(), 0.0);
    motion_ = 0.0;
    coming_ = 0.0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        const ContactCandidate& candidate = candidates[c];
        if (candidate.partner == ContactPartner::tool || candidate.partner == ContactPartner::bag) {
            watches_[c].drift = (candidate.partner == ContactPartner::tool ? 1 : first_bag) + candidate.index;
        }
    }
}

/// Chords, not arcs: the same to third order in a substep, and without trigonometry.
void ExplicitContact::follow_partners(const PartnerPoses& after) {
    std::size_t next = 1;
    double farthest = 0.0;
    for (const std::vector<Pose>* partners : {&after.tools, &after.bags}) {
        for (const Pose& now : *partners) {
            Drift& drift = drifts_[next++];
            const double shift = (now.position - drift.last.position).norm();
            const double turn = 2.0 * (now.orientation * drift.last.orientation.conjugate()).vec().norm();
            drift.shift += shift;
            drift.turn += turn;
            drift.last = now;
            farthest = std::max(farthest, shift + turn * longest_arm);
        }
    }
    motion_ += coming_ + farthest;
}

/// How far the nodes go with the velocities that contact left them.
void ExplicitContact::note_motion(double dt) {
    double fastest = 0.0;
    for (int i = 0; i < rows_.count; ++i) {
        fastest = std::max(fastest, row(rows_.velocity, i).squaredNorm());
    }
    coming_ = dt * std::sqrt(fastest);
}

inline Vec3 blend(const double* values, const std::array<int, 4>& nodes, const std::array<double, 4>& weights) {
    return weights[0] * row(values, nodes[0]) + weights[1] * row(values, nodes[1]) +
           weights[2] * row(values, nodes[2]) + weights[3] * row(values, nodes[3]);
}

/// Relative to the partner's, at the start of the arm.
template <typename Active, typename Body>
inline Vec3 velocity_of(const Active& active, const Body& body, const double* velocity) {
    const Vec3 own = blend(velocity, active.nodes, active.weights);
    return own - body.velocity - body.angular_velocity.cross(active.arm);
}

template <typename Active, typename Body>
inline void push(const Active& active, const Vec3& impulse, Body& body, double* velocity) {
    for (std::size_t k = 0; k < 4; ++k) {
        row(velocity, active.nodes[k]) += active.share[k] * impulse;
    }
    body.velocity -= body.response * impulse;
    body.angular_velocity -= body.turning_response * active.arm.cross(impulse);
}

Vec3 ExplicitContact::place(const ContactPoint& at) const { return blend(rows_.position, at.nodes, at.weights); }

Vec3 ExplicitContact::pace(const ContactPoint& at) const { return blend(rows_.velocity, at.nodes, at.weights); }

double ExplicitContact::left_to_sleep(const Watch& watch, const Vec3& point) const {
    const Drift& drift = drifts_[watch.drift];
    const double left = watch.free - (drift.shift - watch.shift) - (drift.turn - watch.turn) * watch.arm;
    return left > 0.0 ? left - (point - watch.start).norm() : 0.0;
}

double ExplicitContact::wake_after(const Watch& watch, double left) const {
    return watch.arm < longest_arm ? motion_ + left - spare_motion : 0.0;
}

SurfaceDistance ExplicitContact::measure(const ContactCandidate& candidate, const Pose& pose, const Vec3& point,
                                         Watch& watch) const {
    if (candidate.partner != ContactPartner::bag) {
        return measure_gap(*model_, candidate, pose, point);
    }
    const BagModel& bag = model_->bags[candidate.index];
    const Vec3 local = pose.to_body(point);
    if (!watch.flat || (local - watch.foot).squaredNorm() > flat_square || within_opening(bag, local)) {
        watch.plane = wall_distance(bag, local, candidate.approach);
        watch.foot = local;
        watch.flat = std::isfinite(watch.plane.distance);
        return {watch.plane.distance, pose.orientation * watch.plane.normal};
    }
    return {watch.plane.distance + watch.plane.normal.dot(local - watch.foot), pose.orientation * watch.plane.normal};
}

/// Lets a candidate sleep that is farther than `near` from acting.
void ExplicitContact::rest(const SurfaceDistance& gap, double near, const Pose& pose, const Vec3& point,
                           Watch& watch) const {
    const Drift& drift = drifts_[watch.drift];
    watch.start = point;
    watch.free = gap.distance - near;
    watch.shift = drift.shift;
    watch.turn = drift.turn;
    watch.arm = (point - pose.position).norm() + spare_arm;
}

void ExplicitContact::set_masses(Active& active) const {
    const Body& body = bodies_[active.body];
    const bool node = active.nodes[0] == active.nodes[1];
    double own = node ? active.share[0] + active.share[1] : 0.0;
    for (std::size_t k = 0; k < 4 && !node; ++k) {
        own += active.weights[k] * active.share[k];
    }
    const double response = own + body.response;
    const double turning = active.arm.cross(active.normal).squaredNorm() * body.turning_response;
    const double all_turning = active.arm.squaredNorm() * body.turning_response;
    active.normal_mass = response > 0.0 ? 1.0 / (response + turning) : 0.0;
    active.tangent_mass = response > 0.0 ? 1.0 / (response + all_turning) : 0.0;
}

void ExplicitContact::activate(int index, double dt, const SurfaceDistance& gap, const Pose& old_pose, const Pose& pose,
                               const Vec3& point) {
    const ContactCandidate& candidate = (*candidates_)[index];
    Active active;
    active.candidate = index;
    active.nodes = candidate.at.nodes;
    active.weights = candidate.at.weights;
    for (std::size_t k = 0; k < 4; ++k) {
        active.share[k] = active.weights[k] * rows_.inverse_mass[active.nodes[k]];
    }
    active.friction = candidate.spring.friction;
    active.pull = dt * candidate.hold;
    active.grip = dt * candidate.grip;
    if (candidate.partner == ContactPartner::tool && candidate.hold > 0.0) {
        const auto same = [&](const SuctionGrip& grip) { return grip.tool == candidate.index; };
        const auto found = std::find_if(grips_->begin(), grips_->end(), same);
        active.suction = found == grips_->end() ? -1 : static_cast<int>(found - grips_->begin());
    }
    active.normal = gap.normal;
    const bool carried_along = candidate.partner == ContactPartner::tool;
    const Vec3 carried = carried_along ? Vec3(pose.to_world(old_pose.to_body(point)) - point) : Vec3(Vec3::Zero());
    const double advance = gap.normal.dot(carried);
    active.normal_target = (advance + std::min(-gap.distance - advance, dt * fastest_ejection)) / dt;
    Vec3 wanted = carried / dt;
    if (candidate.touching) {
        const Vec3 old_anchor = old_pose.to_world(candidate.anchor);
        const Vec3 anchor = carried_along ? pose.to_world(candidate.anchor) : old_anchor;
        wanted = (anchor - old_anchor + anchor_pull * (old_anchor - point)) / dt;
    }
    active.tangent_target = wanted - active.normal.dot(wanted) * active.normal;
    if (candidate.partner == ContactPartner::bag) {
        active.body = 1 + candidate.index;
        active.arm = point - pose.position;
    }
    set_masses(active);
    if (candidate.touching) {
        const double push = std::max(-candidate.hold, candidate.force.dot(active.normal));
        active.normal_impulse = dt * push;
        const Vec3 across = candidate.force - candidate.force.dot(active.normal) * active.normal;
        active.tangent_impulse =
            dt * project_on_disc(across, active.friction * (push + candidate.hold) + candidate.grip);
    }
    active_.push_back(active);
}

void ExplicitContact::collect(double dt, const PartnerPoses& before, const PartnerPoses& after) {
    active_.clear();
    for (std::size_t c = 0; c < candidates_->size(); ++c) {
        ContactCandidate& candidate = (*candidates_)[c];
        if (motion_ < wakes_[c]) {
            continue;
        }
        Watch& watch = watches_[c];
        const Vec3 point = place(candidate.at);
        if (const double left = left_to_sleep(watch, point); left > 0.0) {
            wakes_[c] = wake_after(watch, left);
            continue;
        }
        const Pose pose = after.of(candidate.partner, candidate.index);
        const SurfaceDistance gap = measure(candidate, pose, point, watch);
        // Anything that could close within this substep, whatever the others do to it
        const double near =
            std::max(2.0 * dt * (pace(candidate.at).norm() + fastest_push), candidate.hold > 0.0 ? kept_seal : 0.0);
        if (gap.distance < near) {
            watch.free = 0.0;
            wakes_[c] = 0.0;
            activate(static_cast<int>(c), dt, gap, before.of(candidate.partner, candidate.index), pose, point);
        } else {
            candidate.touching = false;
            rest(gap, near, pose, point, watch);
            wakes_[c] = wake_after(watch, watch.free);
        }
    }
}

void ExplicitContact::take_bodies(double dt, const std::vector<BagState>& bags) {
    bodies_.assign(1, Body{});
    for (std::size_t i = 0; i < bags.size(); ++i) {
        const BagInertia inertia = bag_response(model_->bags[i], dt);
        bodies_.push_back({bags[i].velocity, bags[i].angular_velocity, 1.0 / inertia.mass, 1.0 / inertia.turning});
    }
}

/// What a grip bears, the contacts before the same mouth do not bear once more.
double ExplicitContact::pull_left(const Active& active, double dt) const {
    if (active.suction < 0) {
        return active.pull;
    }
    const SuctionGrip& grip = (*grips_)[active.suction];
    return active.pull * std::max(0.0, 1.0 - grip.last.norm() / (dt * grip.limit));
}

/// Over the unsettled contacts; leaves those that changed.
void ExplicitContact::sweep(double dt) {
    std::size_t kept = 0;
    double* const rows = rows_.velocity;
    for (const int index : unsettled_) {
        Active& active = active_[index];
        Body& body = bodies_[active.body];
        const Vec3 velocity = velocity_of(active, body, rows);
        const double along = active.normal.dot(velocity);
        const double pull = pull_left(active, dt);
        const double normal_impulse =
            std::max(-pull, active.normal_impulse + active.normal_mass * (active.normal_target - along));
        if (normal_impulse == 0.0 && active.normal_impulse == 0.0) {
            continue;  // apart, and stays so
        }
        const Vec3 across = velocity - along * active.normal;
        const Vec3 sticking = active.tangent_impulse + active.tangent_mass * (active.tangent_target - across);
        const double limit = active.friction * (normal_impulse + pull) + active.grip;
        const Vec3 tangent_impulse = project_on_disc(sticking, limit);
        active.sliding = sticking.squaredNorm() > limit * limit;
        const Vec3 change =
            (normal_impulse - active.normal_impulse) * active.normal + (tangent_impulse - active.tangent_impulse);
        push(active, change, body, rows);
        active.normal_impulse = normal_impulse;
        active.tangent_impulse = tangent_impulse;
        const double quiet = settled * active.normal_mass;
        if (change.squaredNorm() > quiet * quiet) {
            unsettled_[kept++] = index;
        }
    }
    unsettled_.resize(kept);
}

/// Velocity of a point per impulse on it [1/g]. A node that it has twice counts with both weights.
double ExplicitContact::response(const ContactPoint& at) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < 4; ++l) {
            sum += at.nodes[k] == at.nodes[l] ? at.weights[k] * at.weights[l] * rows_.inverse_mass[at.nodes[k]] : 0.0;
        }
    }
    return sum;
}

void ExplicitContact::push_point(const ContactPoint& at, const Vec3& impulse) {
    for (std::size_t k = 0; k < 4; ++k) {
        row(rows_.velocity, at.nodes[k]) += at.weights[k] * rows_.inverse_mass[at.nodes[k]] * impulse;
    }
}

/// Pairs that could close within this substep.
void ExplicitContact::collect_pairs(double dt) {
    active_pairs_.clear();
    for (std::size_t i = 0; i < pairs_->size(); ++i) {
        const PiecePair& pair = (*pairs_)[i];
        const double gap = pair.normal.dot(place(pair.vertex) - place(pair.foot));
        if (!(gap < 2.0 * dt * ((pace(pair.vertex) - pace(pair.foot)).norm() + fastest_push))) {
            continue;
        }
        const double sum = response(pair.vertex) + response(pair.foot);
        if (sum > 0.0) {
            ActivePair active;
            active.pair = static_cast<int>(i);
            active.target = std::min(-gap / dt, fastest_ejection);
            active.mass = 1.0 / sum;
            active_pairs_.push_back(active);
        }
    }
}

/// Over the unsettled pairs; leaves those that changed.
void ExplicitContact::sweep_pairs() {
    std::size_t kept = 0;
    for (const int index : unsettled_pairs_) {
        ActivePair& active = active_pairs_[index];
        const PiecePair& pair = (*pairs_)[active.pair];
        const Vec3 velocity = pace(pair.vertex) - pace(pair.foot);
        const double along = pair.normal.dot(velocity);
        const double impulse = std::max(0.0, active.impulse + active.mass * (active.target - along));
        if (impulse == 0.0 && active.impulse == 0.0) {
            continue;  // apart, and stays so
        }
        const Vec3 sticking = active.tangent_impulse - active.mass * (velocity - along * pair.normal);
        const Vec3 tangent = project_on_disc(sticking, piece_friction * impulse);
        const Vec3 change = (impulse - active.impulse) * pair.normal + tangent - active.tangent_impulse;
        push_point(pair.vertex, change);
        push_point(pair.foot, -change);
        active.impulse = impulse;
        active.tangent_impulse = tangent;
        const double quiet = settled * active.mass;
        if (change.squaredNorm() > quiet * quiet) {
            unsettled_pairs_[kept++] = index;
        }
    }
    unsettled_pairs_.resize(kept);
}

/// The tissue that a tip holds gets its velocity, as far as the hold goes.
void ExplicitContact::sweep_grips(double dt, const PartnerPoses& before, const PartnerPoses& after) {
    for (SuctionGrip& grip : *grips_) {
        double response = 0.0;
        Vec3 velocity = Vec3::Zero();
        for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
            response += grip.weights[k] * grip.weights[k] * rows_.inverse_mass[grip.nodes[k]];
            velocity += grip.weights[k] * row(rows_.velocity, grip.nodes[k]);
        }
        if (!(response > 0.0)) {
            continue;
        }
        const Vec3 led =
            (after.tools[grip.tool].to_world(grip.mouth) - before.tools[grip.tool].to_world(grip.mouth)) / dt;
        const Vec3 impulse = project_on_disc(grip.last + (led - velocity) / response, dt * grip.limit);
        for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
            row(rows_.velocity, grip.nodes[k]) +=
                grip.weights[k] * rows_.inverse_mass[grip.nodes[k]] * (impulse - grip.last);
        }
        grip.last = impulse;
    }
}

void ExplicitContact::finish(double dt, const PartnerPoses& after) {
    for (const Active& active : active_) {
        ContactCandidate& candidate = (*candidates_)[active.candidate];
        const Vec3 velocity = velocity_of(active, bodies_[active.body], rows_.velocity);
        const double slack = presliding * candidate.at.size;
        const double gap = dt * (active.normal.dot(velocity) - active.normal_target);
        const Vec3 impulse = active.normal_impulse * active.normal + active.tangent_impulse;
        candidate.force = impulse / dt;
        candidate.impulse += impulse;
        if (!candidate.touching && gap >= slack) {
            continue;
        }
        const Vec3 point = place(candidate.at) + dt * velocity;
        move_anchor(after.of(candidate.partner, candidate.index), point, active.normal, active.sliding, gap < slack,
                    slack, candidate);
        if (active.normal_impulse != 0.0) {
            candidate.point = point;
            candidate.normal = active.normal;
            candidate.gap = std::min(0.0, gap);
            candidate.sliding = active.sliding;
        }
    }
}

void ExplicitContact::resolve(double dt, const PartnerPoses& before, const PartnerPoses& after,
                              std::vector<BagState>& bags) {
    follow_partners(after);
    take_bodies(dt, bags);
    collect(dt, before, after);
    collect_pairs(dt);
    for (const Active& active : active_) {
        if (active.normal_impulse == 0.0 && active.tangent_impulse.isZero(0.0)) {
            continue;
        }
        push(active, active.normal_impulse * active.normal + active.tangent_impulse, bodies_[active.body],
             rows_.velocity);
    }
    unsettled_.resize(active_.size());
    std::iota(unsettled_.begin(), unsettled_.end(), 0);
    unsettled_pairs_.resize(active_pairs_.size());
    std::iota(unsettled_pairs_.begin(), unsettled_pairs_.end(), 0);
    for (SuctionGrip& grip : *grips_) {
        grip.last = Vec3::Zero();
    }
    for (int i = 0; i < most_sweeps && (i == 0 || !unsettled_.empty() || !unsettled_pairs_.empty()); ++i) {
        sweep_grips(dt, before, after);
        sweep(dt);
        sweep_pairs();
    }
    for (SuctionGrip& grip : *grips_) {
        grip.impulse += grip.last;
    }
    finish(dt, after);
    for (std::size_t i = 0; i < bags.size(); ++i) {
        bags[i].velocity = bodies_[1 + i].velocity;
        bags[i].angular_velocity = bodies_[1 + i].angular_velocity;
    }
    note_motion(dt);
}

}  // namespace rhexis
