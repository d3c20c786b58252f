// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/microscope.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"

namespace rhexis {
namespace {

/// Why a position cannot be used; empty if it can.
std::string position_fault(const Vec3& position) {
    if (!position.allFinite()) {
        return "a number is not finite";
    }
    const double farthest = position.cwiseAbs().maxCoeff();
    if (farthest > microscope_reach) {
        return std::string("microscope sent ")
            .append(short_number(farthest))
            .append(" mm from the eye, allowed ")
            .append(short_number(microscope_reach))
            .append(" mm");
    }
    return {};
}

}  // namespace

MicroscopeStep next_microscope(const MicroscopeState& previous, const DeviceSample& sample, double dt) {
    if (!sample.present) {
        return {previous, {}};
    }
    if (std::string reason = position_fault(sample.pose.position); !reason.empty()) {
        return {previous, std::move(reason)};
    }
    MicroscopeState state;
    const Vec3 way = sample.pose.position - previous.position;
    const double across = way.head<2>().norm();
    const double share = across > microscope_across_speed * dt ? microscope_across_speed * dt / across : 1.0;
    const double most = microscope_focus_speed * dt;
    state.position.head<2>() =
        share < 1.0 ? Vec2(previous.position.head<2>() + share * way.head<2>()) : Vec2(sample.pose.position.head<2>());
    state.position.z() =
        std::abs(way.z()) > most ? previous.position.z() + std::clamp(way.z(), -most, most) : sample.pose.position.z();
    return {state, {}};
}

}  // namespace rhexis
