// SPDX-License-Identifier: GPL-3.0-or-later
// What a person can do, whatever device it is done with. This table is all there is: the mapping file, the panels and
// the help read it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rhexis::station {

/// How a control is worked.
enum class ControlKind {
    place,  ///< a cursor: its tip is where that is
    rate,   ///< -1 to 1, held: goes on as long as it is held
    level,  ///< 0 to 1: as far as it is pressed
    notch,  ///< so many notches, each a little way
    press,  ///< once, when it goes down
    choice  ///< of a list, by its number from 0: from panels only
};

enum class ControlId {
    tip,
    hand_x,
    hand_y,
    hand_z,
    hand_roll,
    depth,
    squeeze,
    draw_back,
    leading_x,
    leading_y,
    leading_z,
    leading_roll,
    leading_squeeze,
    other_x,
    other_y,
    other_z,
    other_roll,
    other_squeeze,
    fine,
    swap,
    next_instrument,
    put_down,
    meet,
    pedal_travel,
    pedal,
    pedal_up,
    pedal_1,
    pedal_2,
    pedal_3,
    microscope_x,
    microscope_y,
    microscope_focus,
    microscope_zoom,
    microscope_light,
    dial_next,
    dial_turn,
    request_next,
    request,
    pause,
    keep_moment,
    try_again,
    ghost,
    warnings,
    help,
    stop,
    take_instrument,
    choose_dial,
    choose_request
};

struct Control {
    ControlId id = ControlId::tip;
    const char* name = "";
    ControlKind kind = ControlKind::press;
    const char* meaning = "";  ///< one sentence, without its end
};

/// Whether it moves the tip of an instrument, which keys do more slowly than a stick.
bool moves_tip(ControlId id);

std::span<const Control> control_table();
/// Null: there is none of this name.
const Control* find_control(std::string_view name);
const Control& control(ControlId id);

}  // namespace rhexis::station
