// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/guide.hpp"

#include <cmath>

#include "flow/tool.hpp"

namespace rhexis::station {
namespace {

constexpr double some_depth_mm = 0.2;

bool has_pedal(const Stand& stand) { return !stand.dials.empty(); }

}  // namespace

std::optional<std::string> Guide::next(const HandsState& hands, const Stand& stand, const Words& words) {
    if (hands.tracked) {
        return std::nullopt;  // there is no key to be learnt for what real instruments do
    }
    const Mapping& mapping = *hands.mapping;
    const HandState& hand = hands.hands[static_cast<std::size_t>(hands.moving)];
    const bool holds = hand.instrument >= 0;
    const bool by_cursor = mapping.by_cursor();
    const auto keys = [&](ControlId id) { return mapping.inputs_at_hand(id); };
    if (!holds && !took_) {
        return words("Take an instrument: %s", {keys(ControlId::next_instrument)});
    }
    if (holds && !took_) {
        took_ = true;
        jaw_at_first_ = hand.jaw;
    }
    if (holds && by_cursor && !hands.cursor && !hands.paused) {
        return words("The clock waits for your hand: bring the cursor to the tip, or press %s",
                     {keys(ControlId::meet)});
    }
    if (holds && hand.inside && !went_in_) {
        went_in_ = true;
        entry_height_ = hand.wanted.z();
    }
    if (!went_in_ && holds && (hand.wound == "incision" || hand.wound == "side_port")) {
        return words("Go in through the wound: move the tip towards the middle of the eye");
    }
    changed_depth_ = changed_depth_ || (went_in_ && std::abs(hand.wanted.z() - entry_height_) > some_depth_mm);
    if (went_in_ && !changed_depth_) {
        return by_cursor ? words("Deeper and higher: the wheel")
                         : words("Deeper and higher: %s", {keys(ControlId::hand_z)});
    }
    pressed_pedal_ = pressed_pedal_ || hands.pedal > 0.0;
    if (has_pedal(stand) && !pressed_pedal_) {
        return words("Irrigation on: %s; aspiration: %s", {keys(ControlId::pedal_1), keys(ControlId::pedal_2)});
    }
    const bool squeezes =
        holds && stand.instruments[static_cast<std::size_t>(hand.instrument)].squeeze != Squeeze::nothing;
    squeezed_ = squeezed_ || (squeezes && std::abs(hand.jaw - jaw_at_first_) > 0.2);
    if (squeezes && !squeezed_) {
        return words("Close the jaws, press or push: %s", {keys(ControlId::squeeze)});
    }
    return std::nullopt;
}

}  // namespace rhexis::station
