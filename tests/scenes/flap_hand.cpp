// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/flap_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"

namespace rhexis::scenes {
namespace {

constexpr double dt = 0.01;           ///< of a step of the scene [s]
constexpr double speed = 3.0;         ///< of the hand [mm/s]
constexpr double ahead = 0.3;         ///< of where it is that the hand aims at [mm]
constexpr double most_reach = 3.2;    ///< from the end of the tear: the flap is folded over and drawn straight [mm]
constexpr double pupil_radius = 3.6;  ///< the forceps stay in the pupil [mm]
constexpr double jump = 1.2;          ///< farther than that an end is not the one that was followed [mm]
constexpr int steps_between_looks = 15;
constexpr int most_looks = 40;  ///< 6 s

/// Round the axis from one place to another, less than half a turn [degrees].
double angle_between(const Vec3& from, const Vec3& to) {
    const double cross = from.x() * to.y() - from.y() * to.x();
    return std::atan2(cross, from.head<2>().dot(to.head<2>())) * 180.0 / std::numbers::pi;
}

}  // namespace

int node_to_hold(const MembraneState& sheet, const Vec3& end, double behind) {
    const std::vector<Vec3>& rest = sheet.sheet->mesh.nodes;
    int found = -1;
    double most = -1.0;
    for (std::size_t n = 0; n < rest.size(); ++n) {
        const bool inside = rest[n].head<2>().norm() < end.head<2>().norm() + 0.05;
        const double moved = (sheet.position[n] - rest[n]).norm();
        if (inside && std::abs((rest[n] - end).norm() - behind) < 0.25 && moved > most) {
            most = moved;
            found = static_cast<int>(n);
        }
    }
    return found;
}

FlapHand::FlapHand(CapsuleScene& scene, const Vec3& end) : scene_(&scene), end_(end) { follow(); }

/// Other ends of tears may be there: the one that is led is the nearest to where it was.
bool FlapHand::follow() {
    const MembraneState& sheet = scene_->sheet();
    double least = jump;
    Vec3 found = end_;
    node_ = -1;
    for (const TearTip& tip : sheet.tips) {
        const Vec3& place = sheet.sheet->mesh.nodes[at(tip.node)];
        if ((place - end_).norm() < least) {
            least = (place - end_).norm();
            found = place;
            node_ = tip.node;
        }
    }
    round_ += angle_between(end_, found);
    end_ = found;
    return node_ >= 0;
}

bool FlapHand::take_flap(const FlapPull& how) {
    const MembraneState& sheet = scene_->sheet();
    const int node = node_to_hold(sheet, end_, how.held_behind);
    if (node < 0) {
        return false;
    }
    taken_ = sheet.sheet->mesh.nodes[at(node)];
    const Vec3 place = sheet.position[at(node)];
    const Vec3 up = 0.01 * Vec3::UnitZ();
    scene_->put(0, place + up, 1.0);
    scene_->lead(0, place + 2.0 * up, 1.0, 0.0);
    return true;
}

void FlapHand::unfold(const FlapPull& how) {
    const double rise = scene_->sheet().support.lift + how.height;
    scene_->lead(0, taken_ + rise * Vec3::UnitZ(), speed, 0.0);
}

void FlapHand::let_go() {
    scene_->lead(0, scene_->tool(0).pose.position + 0.8 * Vec3::UnitZ(), 4.0, 1.0);
    scene_->withdraw(0);
    for (int i = 0; i < 10; ++i) {
        scene_->step();
    }
    follow();
}

double FlapHand::reach() const { return (scene_->tool(0).pose.position - scene_->sheet().position[at(node_)]).norm(); }

Vec3 FlapHand::aim(const FlapPull& how) const {
    const Vec3& tip = scene_->sheet().position[at(node_)];
    const double angle = (how.inwards + how.steering * (radius() - planned_radius)) * std::numbers::pi / 180.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double across = tip.head<2>().norm();
    const Vec2 outward = tip.head<2>() / across;
    const Vec2 round(-outward.y(), outward.x());
    Vec2 to = tip.head<2>() + (std::max(reach(), how.held_behind) + ahead) * (c * round - s * outward);
    to *= std::min(1.0, pupil_radius / to.norm());
    return scene_->front(to.x(), to.y()) + (scene_->sheet().support.lift + how.height) * Vec3::UnitZ();
}

PullEnd FlapHand::pull_until_done(const FlapPull& how, PullResult& result) {
    const Vec3 first = end_;
    for (int look = 0; look < most_looks; ++look) {
        if (reach() > most_reach) {
            return PullEnd::out_of_reach;
        }
        const Vec3 from = scene_->tool(0).pose.position;
        const Vec3 way = aim(how) - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / (speed * dt))));
        for (int i = 1; i <= std::min(steps, steps_between_looks); ++i) {
            scene_->lead(0, from + way * (static_cast<double>(i) / steps), 1e3, 0.0);
            result.peak_force = std::max(result.peak_force, scene_->force().norm());
            if (!follow()) {
                return PullEnd::end_lost;
            }
            result.torn = (end_ - first).norm();
            if (radius() > how.farthest_radius) {
                return PullEnd::too_far_out;
            }
            if (round_ > how.farthest_round) {
                return PullEnd::gone_round;
            }
        }
        if (result.torn > how.length) {
            return PullEnd::torn;
        }
        if (scene_->sheet().grips.empty()) {
            return PullEnd::slipped;
        }
    }
    return PullEnd::time_up;
}

PullResult FlapHand::pull(const FlapPull& how) {
    PullResult result;
    if (node_ < 0) {
        result.end = PullEnd::end_lost;
        return result;
    }
    if (!take_flap(how)) {
        result.end = PullEnd::nothing_held;
        return result;
    }
    if (how.unfold) {
        unfold(how);
    }
    result.end = follow() ? pull_until_done(how, result) : PullEnd::end_lost;
    let_go();
    return result;
}

}  // namespace rhexis::scenes
