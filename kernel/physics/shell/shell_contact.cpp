// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_contact.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {
namespace {

constexpr double travel_in_thicknesses = 0.5;  // of shell and partner in a step
constexpr double sag = 0.05;  // of the thickness: how far a partner may sink in between samples, if they are rigid
constexpr int finest_level = 3;
constexpr double through = 0.5;  // of the thickness: what is so deep when it is first met is on the other side
constexpr double smooth = 1.0;   // radius of partners without an edge, against which the shell's own bend counts [mm]

auto rank(const ShellTouch& touch) {
    return std::tuple(static_cast<int>(touch.partner), touch.index, touch.sample, touch.front);
}

std::vector<std::uint8_t> free_of(const ShellModel& model) {
    std::vector<std::uint8_t> free(6 * model.mesh.nodes.size(), 1);
    for (const ShellHold& hold : model.holds) {
        for (std::size_t i = 0; i < 6; ++i) {
            free[6 * at(hold.node) + i] = hold.held[i] ? 0 : 1;
        }
    }
    return free;
}

std::vector<std::array<int, 2>> each_once(std::vector<std::array<int, 2>> pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

Vec3 across(const Vec3& v, const Vec3& normal) { return v - normal.dot(v) * normal; }

}  // namespace

ShellContacts::ShellContacts(const ShellModel& model, const ShellContactSettings& settings)
    : model_(&model),
      settings_(settings),
      thinnest_(*std::min_element(model.thickness.begin(), model.thickness.end())),
      edge_(mean_edge(model.mesh)),
      modulus_(model.material.young_modulus * (model.relaxation ? 1.0 + model.relaxation->branch_share : 1.0)),
      tack_{model.tack, model.tack_range},
      free_(free_of(model)),
      layers_(model),
      most_travel_(travel_in_thicknesses * thinnest_) {}

/// As fine as a partner of that radius asks for: an edge of it sinks in between two samples by square / (8 radius).
int ShellContacts::level_for(double radius) const {
    int level = 1;
    while (level < finest_level &&
           edge_ * edge_ / (1 << 2 * level) > 8.0 * sag * thinnest_ * (radius + 0.5 * thinnest_)) {
        ++level;
    }
    return level;
}

const ShellSamples& ShellContacts::samples_at(int level) {
    level = settings_.level.value_or(level);
    const auto found = samples_.find(level);
    return found != samples_.end() ? found->second
                                   : samples_.emplace(level, shell_samples(*model_, level)).first->second;
}

void ShellContacts::find_points(const ShellSamples& on) {
    if (points_of_ == &on) {
        return;
    }
    points_of_ = &on;
    points_.resize(on.samples.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i] = pose_.at(on.samples[i].place);
    }
}

const ShellPlace& ShellContacts::place(const Contact& contact) const {
    return contact.on->samples[at(contact.touch.sample)].place;
}

/// Frame in which friction remembers a partner; share: of the step, 0 or 1.
Pose ShellContacts::pose_of(ContactPartner partner, int index, double share) const {
    const double when = partners_.from + share * (partners_.to - partners_.from);
    if (partner == ContactPartner::tool || partner == ContactPartner::jaws) {
        return pose_within(partners_.tool_states[at(index)], when);
    }
    if (partner == ContactPartner::tube) {
        const Pose& own = partners_.tubes[at(index)].pose;
        if (partners_.tube_states.empty()) {
            return own;
        }
        const Pose carried = pose_within(partners_.tube_states[at(index)], when);
        return {carried.to_world(own.position), carried.orientation * own.orientation};
    }
    return {};
}

/// share: of the step, 0 or 1.
SurfaceDistance ShellContacts::distance(ContactPartner partner, int index, double share, const Vec3& point) const {
    const Pose pose = partner == ContactPartner::bag ? partners_.bag_poses[at(index)] : pose_of(partner, index, share);
    return distance_to(partners_, partner, index, pose, point);
}

/// Takes over what friction knew of a contact at the end of the last step.
void ShellContacts::add(Contact contact) {
    const std::vector<ShellTouch>& known = state_->touches;
    const auto found = std::lower_bound(known.begin(), known.end(), contact.touch,
                                        [](const ShellTouch& a, const ShellTouch& b) { return rank(a) < rank(b); });
    if (found != known.end() && rank(*found) == rank(contact.touch)) {
        contact.touch.stretch = found->stretch;
        contact.stuck = stuck_area(contact);
    }
    contact.anchor -= contact.touch.stretch;
    list_.push_back(std::move(contact));
}

/// Normal of the surface at a sample [mm^2, not of unit length].
Vec3 ShellContacts::front(const ShellSamples& on, std::size_t sample) const {
    const std::array<int, 3>& n = on.facets[at(on.samples[sample].triangle * on.facets_each)];
    return (points_[at(n[1])] - points_[at(n[0])]).cross(points_[at(n[2])] - points_[at(n[0])]);
}

/// Of the spring on a sample: what comes sideways to the edge meets its face.
double ShellContacts::stiffness(const ShellSamples& on, std::size_t sample, const Vec3& normal) const {
    const ShellSamples::Sample& own = on.samples[sample];
    double area = own.area;
    if (own.edge > 0.0) {
        const Vec3 flat = front(on, sample);
        const double square = flat.squaredNorm() > 0.0 ? normal.dot(flat) * normal.dot(flat) / flat.squaredNorm() : 1.0;
        area = square * own.area + (1.0 - square) * own.edge;
    }
    return settings_.stiffer * modulus_ / own.place.thickness * area;
}

bool ShellContacts::within(int tube, const Vec3& point) const {
    return within_bore(partners_.tubes[at(tube)], pose_of(ContactPartner::tube, tube, 0.0).to_body(point));
}

/// At the start: what is there is on its way through the wound, and nothing is about it but the tube's wall.
bool ShellContacts::in_tube(const Vec3& point) const {
    for (int i = 0; i < static_cast<int>(partners_.tubes.size()); ++i) {
        if (within(i, point)) {
            return true;
        }
    }
    return false;
}

/// Whether the wall of an instrument keeps a point from this tool, unless that is the one that pushes in it.
bool ShellContacts::kept_from(int tool, const Vec3& point) const {
    for (int i = 0; i < static_cast<int>(partners_.tube_tools.size()); ++i) {
        if (partners_.tube_tools[at(i)] != tool && within(i, point)) {
            return true;
        }
    }
    return false;
}

void ShellContacts::meet_rigid(ContactPartner partner, int index, double radius, double reach,
                               const std::optional<Box>& box) {
    const ShellSamples& on = samples_at(level_for(radius));
    find_points(on);
    // what hangs out of an injector may be outside the eye still, and jaws that lose what they held have it about them
    const bool one_sided = partner == ContactPartner::dome ||
                           (partner == ContactPartner::tool && partners_.tools[at(index)].kind == ToolKind::forceps);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const ShellPlace& own = on.samples[i].place;
        if ((box && !box->holds(points_[i])) || (partner == ContactPartner::dome && in_tube(points_[i])) ||
            (partner == ContactPartner::tool && kept_from(index, points_[i]))) {
            continue;
        }
        const SurfaceDistance start = distance(partner, index, 0.0, points_[i]);
        if (!(start.distance - 0.5 * own.thickness < reach)) {
            continue;
        }
        if (one_sided && start.distance < -through * own.thickness) {
            continue;
        }
        Contact contact;
        contact.on = &on;
        contact.touch.partner = partner;
        contact.touch.index = index;
        contact.touch.sample = static_cast<int>(i);
        contact.stiffness = stiffness(on, i, start.normal);
        contact.friction = friction_of(partners_, partner, index);
        contact.lever = -0.5 * own.thickness * start.normal;
        contact.anchor = partner_pose(contact, 0.0).to_body(points_[i] + contact.lever);
        add(std::move(contact));
    }
}

void ShellContacts::meet_tools() {
    for (int i = 0; i < static_cast<int>(partners_.tools.size()); ++i) {
        const ToolModel& tool = partners_.tools[at(i)];
        const ToolState& state = partners_.tool_states[at(i)];
        if (!state.present || tool.parts.empty() ||
            (tool.kind == ToolKind::forceps && (state.jaw > closed_jaw || holds(i)))) {
            continue;
        }
        const ToolState meanwhile = part_of_step(state, partners_.from, partners_.to);
        Box box = swept_box(tool, meanwhile);
        const double reach = most_travel_ + travel(tool, meanwhile);
        const double around = reach + 0.5 * *std::max_element(model_->thickness.begin(), model_->thickness.end());
        box.low -= Vec3::Constant(around);
        box.high += Vec3::Constant(around);
        meet_rigid(ContactPartner::tool, i, thinnest(tool), reach, box);
    }
}

void ShellContacts::look(const ShellState& state, const ShellPartners& partners, std::vector<double> ways) {
    partners_ = partners;
    ways_ = std::move(ways);
    state_ = &state;
    list_.clear();
    start_.resize(2 * state.position.size());
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        start_[2 * n] = state.position[n];
        start_[2 * n + 1].setZero();
    }
    if (partners.sheet != nullptr) {
        start_.insert(start_.end(), partners.sheet->position.begin(), partners.sheet->position.end());
    }
    first_.clear();
    set_iterate(start_);
    points_of_ = nullptr;
    const auto meet_all = [this](ContactPartner partner, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            meet_rigid(partner, static_cast<int>(i), smooth, most_travel_, {});
        }
    };
    meet_all(ContactPartner::plane, partners_.planes.size());
    meet_all(ContactPartner::dome, partners_.domes.size());
    meet_all(ContactPartner::tube, partners_.tubes.size());
    meet_all(ContactPartner::bag, partners_.bags.size());
    meet_jaws();
    meet_tools();
    if (partners.layers) {
        meet_layers();
    }
    if (partners.sheet != nullptr) {
        meet_sheet();
    }
}

std::vector<std::array<int, 2>> ShellContacts::pairs(ContactPartner partner, double gap) const {
    std::vector<std::array<int, 2>> pairs;
    for (const Contact& contact : list_) {
        if (contact.touch.partner != partner || !(contact.gap < gap)) {
            continue;
        }
        for (const int other : contact.foot.nodes) {
            for (const int own : place(contact).nodes) {
                if (own >= 0 && other >= 0) {
                    pairs.push_back({own, other});
                }
            }
        }
    }
    return pairs;
}

std::vector<std::array<int, 2>> ShellContacts::links(double gap) const {
    std::vector<std::array<int, 2>> pairs = this->pairs(ContactPartner::layer, gap);
    for (std::array<int, 2>& pair : pairs) {
        std::sort(pair.begin(), pair.end());
    }
    return each_once(std::move(pairs));
}

std::vector<std::array<int, 2>> ShellContacts::ties(double gap) const {
    return each_once(pairs(ContactPartner::sheet, gap));
}

/// Of layers and membranes: both sides are planes at right angles to the normal where they would touch.
ShellContacts::Meeting ShellContacts::meeting(const Contact& contact, double share) const {
    Meeting now;
    const ShellPlace& own = place(contact);
    now.point = pose_.at(own);
    if (is_held(contact)) {
        return now;
    }
    if (is_flat(contact)) {
        now.normal = contact.normal;
        now.gap = contact.gap + contact.normal.dot(offset(contact, now.point) + contact.anchor);
        return now;
    }
    const SurfaceDistance found = distance(contact.touch.partner, contact.touch.index, share, now.point);
    now.gap = found.distance - 0.5 * own.thickness;
    now.normal = found.normal;
    return now;
}

/// What a layer or a membrane is met at.
Vec3 ShellContacts::foot_of(const Contact& contact) const {
    if (contact.touch.partner == ContactPartner::layer) {
        return pose_.at(contact.foot) + pose_.turned(contact.foot, contact.foot_lever);
    }
    const std::size_t first = 2 * state_->position.size();
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        sum += contact.foot.weights[k] * (*now_)[first + at(contact.foot.nodes[k])];
    }
    return sum;
}

/// From where friction holds it to where it is.
Vec3 ShellContacts::offset(const Contact& contact, const Vec3& point, double share) const {
    const Vec3 own = point + pose_.turned(place(contact), contact.lever);
    if (is_flat(contact)) {
        return own - foot_of(contact) - contact.anchor;
    }
    return own - partner_pose(contact, share).to_world(contact.anchor);
}

/// Of a contact that was there at the end of the last step: the area of its spring, half of it for each side.
double ShellContacts::stuck_area(const Contact& contact) const {
    const bool sticks = contact.touch.partner == ContactPartner::layer && tack_.traction > 0.0;
    return sticks ? 0.5 * contact.stiffness * place(contact).thickness / (settings_.stiffer * modulus_) : 0.0;
}

/// Pushed apart, or held together without friction. Where the pull falls with the gap its stiffness is left at nothing,
/// so that it stays positive semidefinite.
SpringResponse ShellContacts::respond(const Contact& contact, const Meeting& now) const {
    if (is_held(contact)) {
        return lead(contact, now);
    }
    if (now.gap < 0.0) {
        return push(contact, now);
    }
    const TackPull held = tack_at(tack_, now.gap);
    SpringResponse response;
    response.normal_force = -contact.stuck * held.pull;
    response.force = response.normal_force * now.normal;
    response.stiffness = contact.stuck * std::max(0.0, held.slope) * now.normal * now.normal.transpose();
    return response;
}

/// Stiffness of what friction or jaws hold [uN/mm].
double ShellContacts::sticking(const Contact& contact) const {
    return (is_held(contact) ? 1.0 : settings_.stick) * contact.stiffness;
}

/// Without friction.
double ShellContacts::energy_of(const Contact& contact, const Meeting& now, double share) const {
    if (is_held(contact)) {
        const double length = offset(contact, now.point, share).norm();
        const double kept = std::min(length, contact.most / contact.stiffness);
        return contact.stiffness * kept * (length - 0.5 * kept);
    }
    return now.gap < 0.0 ? normal_energy(contact, now.gap) : contact.stuck * tack_at(tack_, now.gap).energy;
}

/// From the middle surface to where something rigid touches it.
Vec3 ShellContacts::arm(const Contact& contact, const Meeting& now) const {
    return is_held(contact) ? Vec3(Vec3::Zero()) : Vec3(-0.5 * place(contact).thickness * now.normal);
}

/// Whether the next step must know of it. place: in the frame of what it touches.
bool ShellContacts::is_kept(const Contact& contact, const Vec3& place) const {
    if (is_held(contact)) {
        return still_holds(contact, place);
    }
    return contact.friction > 0.0 || stuck_area(contact) > 0.0;
}

/// The spring of friction.hpp with a soft onset.
SpringResponse ShellContacts::push(const Contact& contact, const Meeting& now) const {
    const double onset = settings_.onset * place(contact).thickness;
    const double depth = -now.gap;
    const double softened = depth < onset ? 0.5 * depth * depth / onset : depth - 0.5 * onset;
    SpringResponse pushed = spring_contact({contact.stiffness, contact.friction, settings_.stick}, -softened,
                                           now.normal, offset(contact, now.point), true);
    if (depth < onset) {
        pushed.stiffness -= (1.0 - depth / onset) * contact.stiffness * now.normal * now.normal.transpose();
    }
    return pushed;
}

double ShellContacts::normal_energy(const Contact& contact, double gap) const {
    const double onset = settings_.onset * place(contact).thickness;
    const double depth = std::max(0.0, -gap);
    if (depth < onset) {
        return contact.stiffness * depth * depth * depth / (6.0 * onset);
    }
    return contact.stiffness * (0.5 * depth * (depth - onset) + onset * onset / 6.0);
}

void ShellContacts::fill(const Contact& contact, const Meeting& now, const SpringResponse& pushed,
                         ContactTerm& term) const {
    term.force = pushed.force;
    term.stiffness = pushed.stiffness;
    term.nodes = {-1, -1, -1};
    term.more.reserve(12);
    const ShellPlace& own = place(contact);
    if (contact.touch.partner == ContactPartner::layer) {
        pose_.add_shares(own, contact.lever, true, 1.0, free_, term.more);
        pose_.add_shares(contact.foot, contact.foot_lever, true, -1.0, free_, term.more);
    } else if (contact.touch.partner == ContactPartner::sheet) {
        pose_.add_shares(own, contact.lever, true, 1.0, free_, term.more);
        const int first = 2 * static_cast<int>(state_->position.size());
        for (std::size_t k = 0; k < 3; ++k) {
            term.more.push_back({first + contact.foot.nodes[k], -contact.foot.weights[k] * Mat3::Identity()});
        }
    } else {
        pose_.add_shares(own, arm(contact, now), false, 1.0, free_, term.more);
    }
    if (!settings_.turns) {
        const int first = 2 * static_cast<int>(state_->position.size());
        std::erase_if(term.more,
                      [first](const ContactShare& share) { return share.node < first && share.node % 2 == 1; });
    }
}

void ShellContacts::terms(const std::vector<Vec3>& points, std::vector<ContactTerm>& terms) {
    if (list_.empty()) {
        return;
    }
    set_iterate(points);
    if (first_.empty()) {
        first_ = points;
        for (Contact& contact : list_) {
            if (is_flat(contact)) {
                contact.known = known_of(contact, meeting(contact).gap);
            }
        }
    }
    for (const Contact& contact : list_) {
        if (const std::optional<Meeting> now = touching(contact)) {
            fill(contact, *now, respond(contact, *now), terms.emplace_back());
        }
    }
}

double ShellContacts::normal_energy(const std::vector<Vec3>& points) {
    set_iterate(points);
    double sum = 0.0;
    for (const Contact& contact : list_) {
        sum += energy_of(contact, meeting(contact));
    }
    return sum;
}

void ShellContacts::settle(const std::vector<Vec3>& points, std::vector<ShellTouch>& touches) {
    work_ = {};
    if (settings_.accounts) {
        account_start();
    }
    set_iterate(points);
    deepest_ = 0.0;
    touching_ = 0;
    std::vector<ShellTouch> kept;
    for (std::size_t i = 0; i < list_.size(); ++i) {
        Contact& contact = list_[i];
        const std::optional<Meeting> met = touching(contact);
        contact.force.setZero();
        if (!met) {
            work_.lost += settings_.accounts ? at_start_[i].energy : 0.0;
            continue;
        }
        const Meeting& now = *met;
        const Vec3 from_anchor = offset(contact, now.point);
        const SpringResponse pushed = respond(contact, now);
        const Vec3 tangential = is_held(contact) ? from_anchor : across(from_anchor, now.normal);
        const double size = tangential.norm();
        const double share = size > 0.0 ? std::min(1.0, pushed.stretch / size) : 0.0;
        const Vec3 stretch = share * tangential;
        contact.force = pushed.force;
        touching_ += now.gap < 0.0 ? 1 : 0;
        deepest_ = std::max(deepest_, -now.gap / place(contact).thickness);
        const double stiff = sticking(contact);
        const double slid = size - stretch.norm();
        work_.stored += (is_held(contact) ? 0.0 : energy_of(contact, now)) + 0.5 * stiff * stretch.squaredNorm();
        work_.friction += stiff * stretch.norm() * slid;
        const Pose end = partner_pose(contact, 1.0);
        const Vec3 own = end.to_body(now.point + arm(contact, now));
        const Vec3 way = end.to_world(own) - partner_pose(contact, 0.0).to_world(own);
        work_.brought += pushed.force.dot(way);
        if (settings_.accounts) {
            account_end(i, points, now, pushed, stretch, way);
        }
        if (is_kept(contact, own)) {
            contact.touch.stretch = end.orientation.conjugate() * stretch;
            kept.push_back(contact.touch);
        }
    }
    std::sort(kept.begin(), kept.end(), [](const ShellTouch& a, const ShellTouch& b) { return rank(a) < rank(b); });
    touches = std::move(kept);
}

Vec3 ShellContacts::force_of(ContactPartner partner, int index) const {
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : list_) {
        if (contact.touch.partner == partner && contact.touch.index == index) {
            sum += contact.force;
        }
    }
    return sum;
}

}  // namespace rhexis
