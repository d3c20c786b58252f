// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/controls.hpp"

#include <algorithm>
#include <array>

namespace rhexis::station {
namespace {

using enum ControlKind;
using Id = ControlId;

constexpr auto table = std::to_array<Control>({
    {Id::tip, "tip", place, "The tip of the hand that moves is where the cursor is"},
    {Id::hand_x, "hand.x", rate, "The tip of the hand that moves, to the right"},
    {Id::hand_y, "hand.y", rate, "The same, away from you"},
    {Id::hand_z, "hand.z", rate, "The same, up to the microscope"},
    {Id::hand_roll, "hand.roll", rate, "Rolls its instrument between the fingers, against the clock"},
    {Id::depth, "depth", notch, "The tip of the hand that moves, up by a little"},
    {Id::squeeze, "squeeze", level, "Closes the jaws, presses the syringe, pushes the plunger, holds the hook"},
    {Id::draw_back, "draw_back", level, "Draws back a plunger or lets go of a hook, which stay where they were left"},
    {Id::leading_x, "leading.x", rate, "The tip of the leading hand, to the right"},
    {Id::leading_y, "leading.y", rate, "The same, away from you"},
    {Id::leading_z, "leading.z", rate, "The same, up to the microscope"},
    {Id::leading_roll, "leading.roll", rate, "Rolls its instrument"},
    {Id::leading_squeeze, "leading.squeeze", level, "Squeezes with the leading hand"},
    {Id::other_x, "other.x", rate, "The tip of the other hand, to the right"},
    {Id::other_y, "other.y", rate, "The same, away from you"},
    {Id::other_z, "other.z", rate, "The same, up to the microscope"},
    {Id::other_roll, "other.roll", rate, "Rolls its instrument"},
    {Id::other_squeeze, "other.squeeze", level, "Squeezes with the other hand"},
    {Id::fine, "fine", level, "All movements a fifth as fast, as long as it is held"},
    {Id::swap, "swap", press, "The cursor moves the other hand"},
    {Id::next_instrument, "next_instrument", press, "Takes the next instrument of the stand into the hand that moves"},
    {Id::put_down, "put_down", press, "Puts the instrument of the hand that moves down, where it is outside the eye"},
    {Id::meet, "meet", press, "The hand goes on from where its instrument is, without going to meet it"},
    {Id::pedal_travel, "pedal.travel", rate, "Presses the pedal, or lets it up, as long as it is held"},
    {Id::pedal, "pedal", level, "The pedal, as far as it is pressed"},
    {Id::pedal_up, "pedal.up", press, "The foot goes off the pedal"},
    {Id::pedal_1, "pedal.1", press, "The foot goes to position 1, irrigation"},
    {Id::pedal_2, "pedal.2", press, "The foot goes to the end of position 2, aspiration"},
    {Id::pedal_3, "pedal.3", press, "The foot goes to the end of position 3, ultrasound"},
    {Id::microscope_x, "microscope.x", rate, "The microscope, to the right"},
    {Id::microscope_y, "microscope.y", rate, "The microscope, away from you"},
    {Id::microscope_focus, "microscope.focus", rate, "Its focus, up"},
    {Id::microscope_zoom, "microscope.zoom", rate, "Its zoom: larger"},
    {Id::microscope_light, "microscope.light", rate, "Its light: brighter"},
    {Id::dial_next, "dial.next", press, "Chooses the next dial of the machine"},
    {Id::dial_turn, "dial.turn", notch, "Turns the chosen dial up"},
    {Id::request_next, "request.next", press, "Chooses the next request to the staff"},
    {Id::request, "request", press, "Asks the staff for what is chosen"},
    {Id::pause, "pause", press, "The clock stands still, or goes on"},
    {Id::keep_moment, "keep_moment", press, "Keeps this moment, to try again from"},
    {Id::try_again, "try_again", press, "Goes back to the moment that was kept"},
    {Id::ghost, "ghost", press, "Shows, or hides, how an expert does it"},
    {Id::warnings, "warnings", press, "Warns, or does not, of what is about to go wrong"},
    {Id::help, "help", press, "Shows, or hides, what each key and button does"},
    {Id::stop, "stop", press, "Ends the exercise; the report opens"},
    {Id::take_instrument, "take_instrument", choice, "Takes this instrument of the stand into the hand that moves"},
    {Id::choose_dial, "choose_dial", choice, "Chooses this dial of the machine"},
    {Id::choose_request, "choose_request", choice, "Chooses this request to the staff"},
});

}  // namespace

std::span<const Control> control_table() { return table; }

bool moves_tip(ControlId id) {
    const auto within = [id](Id first, Id last) { return id >= first && id <= last; };
    return within(Id::hand_x, Id::hand_z) || within(Id::leading_x, Id::leading_z) || within(Id::other_x, Id::other_z);
}

const Control* find_control(std::string_view name) {
    const auto* found = std::find_if(table.begin(), table.end(), [&](const Control& one) { return one.name == name; });
    return found == table.end() ? nullptr : found;
}

const Control& control(ControlId id) { return table[static_cast<std::size_t>(id)]; }

}  // namespace rhexis::station
