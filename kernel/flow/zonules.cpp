// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/zonules.hpp"

#include <algorithm>

#include "flow/bag.hpp"

namespace rhexis {

namespace {

constexpr double full_turn = 360.0;

std::size_t meridians(const BagModel& model) { return model.zonules.size() / 2; }

bool is_lost(const ZonuleState& state, std::size_t meridian) {
    return state.broken[2 * meridian] != 0 && state.broken[2 * meridian + 1] != 0;
}

Vec3 across(const Vec3& place) { return Vec3(place.x(), place.y(), 0.0); }

/// Nearest meridian of each hook: 1 where there is one.
std::vector<std::uint8_t> hooked_meridians(const BagModel& model, const ZonuleState& state) {
    std::vector<std::uint8_t> hooked(meridians(model), 0);
    for (const CapsuleHook& hook : state.hooks) {
        std::size_t best = 0;
        double most = -1.0;
        for (std::size_t m = 0; m < hooked.size(); ++m) {
            const double along = across(model.zonules[2 * m].on_ciliary).normalized().dot(across(hook.on_bag));
            if (along > most) {
                most = along;
                best = m;
            }
        }
        hooked[best] = 1;
    }
    return hooked;
}

/// Longest run, round the ring, of meridians for which open is 1.
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};
Run longest_run(const std::vector<std::uint8_t>& open) {
    Run best;
    const std::size_t n = open.size();
    for (std::size_t start = 0; start < n; ++start) {
        std::size_t count = 0;
        while (count < n && open[(start + count) % n] != 0) {
            ++count;
        }
        if (count > best.count) {
            best = {start, count};
        }
    }
    return best;
}

std::vector<std::uint8_t> lost_meridians(const BagModel& model, const ZonuleState& state) {
    std::vector<std::uint8_t> lost(meridians(model), 0);
    for (std::size_t m = 0; m < lost.size(); ++m) {
        lost[m] = is_lost(state, m) ? 1 : 0;
    }
    return lost;
}

}  // namespace

ZonuleState rest_state(const ZonuleModel& model) {
    ZonuleState state;
    state.broken = model.lost;
    return state;
}

ZonuleGap widest_gap(const BagModel& model, const ZonuleState& state) {
    const std::vector<std::uint8_t> lost = lost_meridians(model, state);
    const Run run = longest_run(lost);
    ZonuleGap gap;
    if (run.count == 0) {
        return gap;
    }
    gap.width_deg = full_turn * static_cast<double>(run.count) / static_cast<double>(lost.size());
    const Vec3 first = across(model.zonules[2 * run.first].on_ciliary).normalized();
    const Vec3 last = across(model.zonules[2 * ((run.first + run.count - 1) % lost.size())].on_ciliary).normalized();
    Vec3 middle = first + last;
    if (gap.width_deg > 0.5 * full_turn) {
        middle = -middle;  // the short way between them goes over the side that holds
    }
    gap.middle = middle.norm() > 1e-9 ? Vec3(middle.normalized()) : Vec3(-first.y(), first.x(), 0.0);
    return gap;
}

double bridged_share(const BagModel& model, const ZonuleState& state) {
    const ZonuleModel& own = *model.breakable;
    if (!(state.ring >= 1.0)) {
        return 0.0;
    }
    const double width = widest_gap(model, state).width_deg;
    return std::clamp((own.ring_fails_deg - width) / (own.ring_fails_deg - own.ring_holds_deg), 0.0, 1.0);
}

double unsupported_deg(const BagModel& model, const ZonuleState& state) {
    std::vector<std::uint8_t> open = lost_meridians(model, state);
    const std::vector<std::uint8_t> hooked = hooked_meridians(model, state);
    for (std::size_t m = 0; m < open.size(); ++m) {
        open[m] = open[m] != 0 && hooked[m] == 0 ? 1 : 0;
    }
    const double width = full_turn * static_cast<double>(longest_run(open).count) / static_cast<double>(open.size());
    return width * (1.0 - bridged_share(model, state));
}

double lost_deg(const BagModel& model, const ZonuleState& state) {
    const auto broken =
        std::count_if(state.broken.begin(), state.broken.end(), [](std::uint8_t one) { return one != 0; });
    return full_turn * static_cast<double>(broken) / static_cast<double>(model.zonules.size());
}

ZonuleShares::ZonuleShares(const BagModel& model, const BagState& state) {
    if (!model.breakable || !state.zonules ||
        std::none_of(state.zonules->broken.begin(), state.zonules->broken.end(),
                     [](std::uint8_t one) { return one != 0; })) {
        return;
    }
    broken_ = &state.zonules->broken;
    bridged_ = bridged_share(model, *state.zonules);
    mean_ = 1.0 - lost_deg(model, *state.zonules) / full_turn;
}

double ZonuleShares::of(std::size_t zonule) const {
    if (broken_ == nullptr) {
        return 1.0;
    }
    const double whole = (*broken_)[zonule] != 0 ? 0.0 : 1.0;
    return bridged_ * mean_ + (1.0 - bridged_) * whole;
}

Vec3 missing_pull(const BagModel& model, std::size_t zonule, double share) {
    const ZonuleSpring& spring = model.zonules[zonule];
    if (!(spring.on_bag.z() > 0.0)) {
        return Vec3::Zero();
    }
    const Vec3 outward = (spring.on_ciliary - spring.on_bag).normalized();
    return -(1.0 - share) * spring.stiffness * model.breakable->rest_stretch * outward;
}

Vec3 hook_force(const ZonuleModel& model, const CapsuleHook& hook, const Pose& bag) {
    const Vec3 line = hook.at_limbus - bag.to_world(hook.on_bag);
    const double length = line.norm();
    const double pull = model.hook_pull + model.hook_stiffness * (length - hook.length);
    return length > 0.0 && pull > 0.0 ? Vec3(pull / length * line) : Vec3::Zero();
}

Mat3 hook_stiffness(const ZonuleModel& model, const CapsuleHook& hook, const Pose& bag) {
    if (hook_force(model, hook, bag).isZero()) {
        return Mat3::Zero();
    }
    const Vec3 along = (hook.at_limbus - bag.to_world(hook.on_bag)).normalized();
    return model.hook_stiffness * along * along.transpose();
}

}  // namespace rhexis
