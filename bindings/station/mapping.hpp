// SPDX-License-Identifier: GPL-3.0-or-later
// Which key, button or axis works which control: a file that a person may change, also while the station runs.
//
//   {"key": {"Tab": "swap", "W": "hand.y", "S": "-hand.y"}, "mouse": {"move": "tip", "wheel": "depth"},
//    "pad": {"leftx": "other.x"}, "pedal": {"0": "pedal"}, "tuning": {"tip_mm_s": 4}}
//
// A minus before a control turns it round.
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "station/controls.hpp"
#include "station/user_event.hpp"

namespace rhexis::station {

struct Binding {
    const Control* control = nullptr;
    double sign = 1.0;
};

/// How fast things go. Ranges: mapping.cpp.
struct Tuning {
    double tip_mm_s = 12.0;      ///< of a tip under a stick, at most; half way it is a quarter as fast
    double key_share = 0.25;     ///< of that, under a key
    double notch_mm = 0.05;      ///< of depth, per notch
    double roll_deg_s = 180.0;   ///< of an instrument between the fingers
    double fine = 0.2;           ///< of all that, while `fine` is held
    double pedal_per_s = 4.0;    ///< positions of the pedal under keys
    double dead_zone = 0.12;     ///< of a stick
    double pedal_rest = -1.0;    ///< what the axis of the pedal says when the foot is off it
    double pedal_full = 1.0;     ///< and when it is pressed down
    double pedal_first = 0.08;   ///< share of its travel from which it is at position 1,
    double pedal_second = 0.33;  ///< 2
    double pedal_third = 0.66;   ///< and 3
};

class Mapping {
public:
    /// Fails on what the file may not say, with the nearest that it may.
    static Result<Mapping> from(const nlohmann::json& json);
    static Result<Mapping> read(const std::string& path);

    /// Changes one input or tuning, as the event says. Fails, and changes nothing, where a file could not say it.
    Status rebind(const UserEvent& event);
    /// What makes this mapping that one, event by event.
    [[nodiscard]] std::vector<UserEvent> changes_to(const Mapping& that) const;

    /// Null: nothing is on it. source: "key.Tab", "mouse.left", "pad.a", "pedal.0".
    [[nodiscard]] const Binding* find(const std::string& source) const;
    [[nodiscard]] const std::map<std::string, Binding>& bindings() const { return bindings_; }
    [[nodiscard]] const Tuning& tuning() const { return tuning_; }
    /// A cursor moves the tips, not sticks.
    [[nodiscard]] bool by_cursor() const { return find("mouse.move") != nullptr; }
    [[nodiscard]] nlohmann::json to_json() const;

    /// What works a control: "Tab, pad.y"; empty: nothing does. way: 1 and -1 for those that work it this way or turned
    /// round, 0 for all, told apart.
    [[nodiscard]] std::string inputs_of(ControlId id, double way = 0.0) const;
    /// The same, of the devices that are at hand: who leads a cursor has no pad in the other hand.
    [[nodiscard]] std::string inputs_at_hand(ControlId id) const;

private:
    [[nodiscard]] std::string list(ControlId id, double way, bool at_hand) const;

    std::map<std::string, Binding> bindings_;
    Tuning tuning_;
};

/// Whole, or not at all; its folder is made.
Status write_mapping(const Mapping& mapping, const std::string& path);

/// Of an event: "key.Tab", "mouse.move"; empty: it is of no input.
std::string source_of(const UserEvent& event);

/// Where the file lies that is taken where none is named. left: for who leads with the left hand.
std::string standard_mapping(const std::string& root, bool pad, bool left);

/// Where a person's own is kept, which is taken before the standard one: beside other programs' settings. Empty: there
/// is no home.
std::string own_mapping(bool pad, bool left);

}  // namespace rhexis::station
