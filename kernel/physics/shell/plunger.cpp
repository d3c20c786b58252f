// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/plunger.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

constexpr double too_much = 1.01;       // over the most force, at which a step is made again
constexpr double least_share = 0.05;    // of a way that is worth going, else it holds still
constexpr double forgets = 0.5;         // what is left of a stiffness after a step that it did not limit
constexpr double forgets_slowly = 0.8;  // likewise after one that it did

}  // namespace

double plunger_goal(const Cartridge& cartridge, const PlungerState& before, double wanted, double dt) {
    const double most_way = cartridge.fastest * dt;
    double way = std::clamp(wanted - before.pushed, -most_way, most_way);
    if (way > 0.0 && before.stiffness > 0.0) {
        const double spare = (cartridge.most_force - before.force) / before.stiffness;
        way = std::clamp(spare, -most_way, way);
    }
    return before.pushed + way;
}

std::optional<double> nearer_goal(const Cartridge& cartridge, const PlungerState& before, double goal, double force) {
    if (force <= too_much * cartridge.most_force || goal <= before.pushed) {
        return std::nullopt;
    }
    if (!std::isfinite(force)) {
        return before.pushed;
    }
    // the force grows the faster the farther it goes: the chord is on the safe side
    const double share = (cartridge.most_force - before.force) / (force - before.force);
    return share < least_share ? before.pushed : before.pushed + share * (goal - before.pushed);
}

PlungerState pushed_plunger(const PlungerState& before, double goal, double force, bool limited, double tried) {
    const double way = goal - before.pushed;
    const double kept = way > 0.0 ? (limited ? forgets_slowly : forgets) * before.stiffness : before.stiffness;
    return {goal, force, std::max({tried, kept, way > 0.0 ? (force - before.force) / way : 0.0})};
}

}  // namespace rhexis
