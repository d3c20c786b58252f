// SPDX-License-Identifier: GPL-3.0-or-later
// window, event file -> station: what a person does with the devices on the desk, before anything is made of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "flow/device_sample.hpp"

namespace rhexis::station {

enum class EventKind {
    key,      ///< name: of the key, as SDL says it; value 1 down, 0 up
    pointer,  ///< x, y: where the cursor is, heights of the picture from its middle, to the right and up
    button,   ///< of the mouse: "left", "middle", "right", "back", "forward"; value 1 down, 0 up
    wheel,    ///< value: notches, away from the hand positive
    axis,     ///< of a pad or pedal: name "pad.leftx", "pedal.0"; value -1 to 1, of a trigger 0 to 1
    press,    ///< a button of a pad or pedal: name "pad.a", "pedal.1"; value 1 down, 0 up
    control,  ///< from a panel: name of a control (controls.hpp), value
    bind,     ///< the mapping changes: name of an input ("key.Tab") and its control ("-hand.y"; "": none), or of a
              ///< tuning ("tuning.fine") and its value
    focus,    ///< value 1: the window has the keyboard; 0: it has lost it, and with it all keys that were held; name
              ///< "away": the whole computer was away, or too busy, for a moment
    device,   ///< name "pad" or "pedal"; value 1: it is there; 0: it has gone, and with it all that it held
    staff,  ///< an instructor at the theatre's monitor: name "inject", "put_right" or "level" and which, "note" and its
            ///< text, "rewind" by so many seconds, "pause", "go_on", "warn" (value 1 or 0)
    quit,   ///< the window is closed
    tracking,  ///< by which the instruments are seen: value 1, the clock may go on; 0, it stands: name why, as in "%s
               ///< is lost", control of what
    tracked,   ///< an instrument as it is seen: its name, value 1 there, 0 put away, and sample, whose index and pedal
               ///< say nothing; or name "pedal" and value, its position
    asked      ///< of the staff, by the tracking system: name as asked.hpp has it
};

struct UserEvent {
    EventKind kind = EventKind::key;
    std::string name;
    double value = 0.0;
    double x = 0.0;
    double y = 0.0;
    std::string control{};  ///< of `bind` its control; of `staff` which, or the text
    DeviceSample sample{};  ///< of `tracked`
};

/// One line of an event file, without its end: {"event":"key","name":"Tab","value":1}.
nlohmann::json to_json(const UserEvent& event);
/// The error names the field, its value and what is allowed.
Result<UserEvent> event_from(const nlohmann::json& json);

}  // namespace rhexis::station
