// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that a tracking system sees: what its events make of them.
#include <algorithm>

#include "station/hands.hpp"
#include "station/wound_way.hpp"

namespace rhexis::station {

void Hands::track() {
    TrackedState& tracked = state_.tracked.emplace();
    tracked.given.resize(stand_->instruments.size());
    tracked.seen.resize(stand_->instruments.size());
    for (std::size_t i = 0; i < tracked.given.size(); ++i) {
        tracked.given[i].instrument = static_cast<int>(i);
    }
}

void Hands::take_tracking(const UserEvent& event) {
    if (!state_.tracked) {
        return;
    }
    constexpr double runs = 0.5;
    state_.tracked->runs = event.value > runs;
    state_.tracked->why = {event.name, event.control};
    std::fill(state_.tracked->seen.begin(), state_.tracked->seen.end(), std::nullopt);
}

/// While the clock stands it is only shown where instruments are seen; they stay where the simulation holds them.
void Hands::take_tracked(const UserEvent& event, const Surroundings& around) {
    if (!state_.tracked || state_.paused) {
        return;
    }
    if (event.name == pedal_device) {
        state_.pedal = std::clamp(event.value, 0.0, 3.0);
        state_.pedal_goal.reset();
        return;
    }
    const auto named = [&event](const StandInstrument& one) { return one.name == event.name; };
    const auto found = std::find_if(stand_->instruments.begin(), stand_->instruments.end(), named);
    if (found == stand_->instruments.end()) {
        return;
    }
    const auto i = static_cast<std::size_t>(found - stand_->instruments.begin());
    const bool present = event.value > 0.5;
    if (!state_.tracked->runs) {
        state_.tracked->seen[i] = present ? std::optional<Pose>(event.sample.pose) : std::nullopt;
        return;
    }
    DeviceSample& given = state_.tracked->given[i];
    given = event.sample;
    given.instrument = static_cast<int>(i);
    given.present = present;
    given.pedal = 0.0;
    if (found->hand_held) {
        hold_tracked(given.instrument, around);
    }
}

/// In the hand that has it, or one that has nothing, so that the window shows it as any other; a third has no hand.
void Hands::hold_tracked(int instrument, const Surroundings& around) {
    const auto i = static_cast<std::size_t>(instrument);
    const DeviceSample& given = state_.tracked->given[i];
    const auto holds = [this](int which, int what) {
        return state_.hands[static_cast<std::size_t>(which)].instrument == what;
    };
    const int preferred = through_side_port(instrument) ? other : leading;
    int which = holds(1 - preferred, instrument) ? 1 - preferred : preferred;
    if (!holds(which, instrument)) {
        which = holds(preferred, -1) ? preferred : 1 - preferred;
    }
    HandState& hand = state_.hands[static_cast<std::size_t>(which)];
    if (hand.instrument >= 0 && hand.instrument != instrument) {
        return;
    }
    hand = HandState{};
    if (!given.present) {
        return;
    }
    hand.instrument = instrument;
    hand.tip = hand.wanted = given.pose.position + state_.tracked->shift;
    hand.orientation = given.pose.orientation;
    hand.jaw = given.jaw;
    hand.wound = wound_on_shaft(around, wounds_[i], {hand.tip, hand.orientation});
    const std::optional<Vec3> wound = landmark(around, hand.wound);
    hand.inside = wound && leads_inside(hand.wound) && is_behind(*wound, hand.tip);
}

}  // namespace rhexis::station
