// SPDX-License-Identifier: GPL-3.0-or-later
// What hands take over from a session, and what they give it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "station/hands.hpp"
#include "station/wound_way.hpp"

namespace rhexis::station {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

}  // namespace

Status Hands::take_over(const Session& session, const Surroundings& around) {
    for (std::size_t i = 0; i < session.tools().size(); ++i) {
        const ToolState& tool = session.tools()[i];
        if (!tool.present) {
            continue;
        }
        const int instrument = static_cast<int>(i);
        int which = through_side_port(instrument) ? other : leading;
        which = state_.hands[static_cast<std::size_t>(which)].instrument < 0 ? which : 1 - which;
        take_up(which, instrument, around);
        HandState& hand = state_.hands[static_cast<std::size_t>(which)];
        const WorldState& world = session.state();
        const Pose pose = world.globe ? to_room(*session.world().globe, *world.globe, tool.pose) : tool.pose;
        hand.tip = hand.wanted = pose.position;
        hand.orientation = pose.orientation;
        hand.jaw = tool.jaw;
        hand.wound = wound_on_shaft(around, wounds_[i], pose);
        const std::optional<Vec3> wound = landmark(around, hand.wound);
        hand.inside = wound && leads_inside(hand.wound) && is_behind(*wound, hand.tip);
        if (state_.tracked) {
            state_.tracked->given[i] = {instrument, true, pose, tool.jaw, 0.0};
        }
        const Result<Quat> unrolled = holds_->orientation(tool_name(instrument), wound, hand.tip, 0.0);
        if (!unrolled) {
            return unrolled.error();
        }
        const Quat turn = unrolled.value().conjugate() * pose.orientation;
        hand.roll = std::remainder(2.0 * std::atan2(turn.z(), turn.w()) * degrees, 360.0);
        state_.pedal = std::max(state_.pedal, tool.pedal);
    }
    const std::map<std::string, double>& settings = session.settings();
    for (std::size_t i = 0; i < stand_->dials.size(); ++i) {
        state_.dials[i] = settings.at(stand_->dials[i].setting);
    }
    return success();
}

std::vector<DeviceSample> Hands::samples(const Surroundings& around, double dt) const {
    std::vector<DeviceSample> list(stand_->instruments.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].instrument = static_cast<int>(i);
    }
    if (state_.tracked) {
        list = state_.tracked->given;
        for (DeviceSample& sample : list) {
            const bool by_hand = stand_->instruments[static_cast<std::size_t>(sample.instrument)].hand_held;
            sample.pose.position += by_hand ? state_.tracked->shift : Vec3::Zero();
            sample.pedal = sample.present ? state_.pedal : 0.0;
        }
    }
    for (const HandState& hand : state_.hands) {
        if (hand.instrument >= 0 && !state_.tracked) {
            DeviceSample& sample = list[static_cast<std::size_t>(hand.instrument)];
            sample.present = true;
            sample.pose = {hand.tip, hand.orientation};
            sample.jaw = hand.jaw;
            sample.pedal = state_.pedal;
        }
    }
    if (around.microscope && !list.back().present) {
        DeviceSample& sample = list.back();
        const Vec3 way(level(ControlId::microscope_x), level(ControlId::microscope_y),
                       level(ControlId::microscope_focus));
        sample.present = !way.isZero();
        sample.pose.position = *around.microscope + microscope_mm_s * speed_share() * dt * way;
    }
    return list;
}

std::vector<Command> Hands::take_commands() {
    std::vector<Command> commands;
    for (const int request : std::exchange(state_.requests, {})) {
        commands.push_back({CommandKind::request, stand_->requests[static_cast<std::size_t>(request)].id, 0.0, ""});
    }
    for (const int dial : std::exchange(state_.turned, {})) {
        commands.push_back({CommandKind::adjust, stand_->dials[static_cast<std::size_t>(dial)].setting,
                            state_.dials[static_cast<std::size_t>(dial)], ""});
    }
    return commands;
}

}  // namespace rhexis::station
