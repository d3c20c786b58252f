// SPDX-License-Identifier: GPL-3.0-or-later
// What a person's hands and foot do: from controls to samples. A value that is copied: the picture runs ahead of the
// simulation with a copy of its own, so that an instrument shows where the hand is now.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flow/device_sample.hpp"
#include "flow/percept.hpp"
#include "lua/hold_script.hpp"
#include "station/mapping.hpp"
#include "station/sight.hpp"
#include "station/stand.hpp"
#include "station/tracked_state.hpp"

namespace rhexis::station {

/// What hands need to know of the scene as it is now.
struct Surroundings {
    Sight sight;
    Percept percept;                 ///< what shows, wounds among it
    std::optional<Vec3> microscope;  ///< its position; none: the scene has none
};

inline constexpr double microscope_mm_s = 4.0;  ///< of the microscope under keys, at most: as its motors

inline constexpr double foot_per_s = 8.0;  ///< positions of the pedal, where the foot goes to one: as virtual surgeons

inline constexpr double meets_within = 0.3;  ///< of a cursor and the tip that it is to move [mm]

inline constexpr int leading = 0;
inline constexpr int other = 1;

struct HandState {
    int instrument = -1;         ///< index in the scene; -1: empty
    std::string wound{};         ///< landmark that its shaft is turned about: the nearest, until it is inside
    Vec3 wanted = Vec3::Zero();  ///< where the tip is to be, as far as its wound lets it [mm]
    Vec3 tip = Vec3::Zero();     ///< [mm]
    Quat orientation = Quat::Identity();
    double out = 0.0;     ///< how far it is outside its wound; below 0: within the limbus [mm]
    bool inside = false;  ///< its tip has gone in through its wound
    double roll = 0.0;    ///< [deg]
    double jaw = 0.0;     ///< as of a sample
};

/// Changes with each event and step.
struct HandsState {
    std::array<HandState, 2> hands{};
    std::optional<Cursor> cursor;  ///< none: it has not met its instrument
    Cursor last_cursor = Cursor::Zero();
    std::optional<TrackedState> tracked{};    ///< none: devices on the desk move the hands
    std::shared_ptr<const Mapping> mapping;   ///< never null
    std::map<std::string, double> held;       ///< by source, what is down or pushed
    std::map<std::string, double> unmoved_s;  ///< by stick that is pushed: since it moved last
    double pedal = 0.0;                       ///< 0 to 3
    std::optional<double> pedal_goal;
    double light = 1.0;         ///< of the microscope
    double zoom = 1.0;          ///< of the picture
    std::vector<double> dials;  ///< their values
    std::vector<int> turned;    ///< dials since the last step
    std::vector<int> requests;  ///< made since the last step
    std::string word;           ///< why something could not be done; empty: nothing to say
    double word_for_s = 0.0;    ///< how much longer it is shown
    int moving = leading;       ///< the hand that the cursor moves
    int dial = 0;               ///< chosen
    int request = 0;            ///< chosen
    bool cursor_moves = false;  ///< a cursor is what moves the hand: it must meet the instrument
    bool paused = false;
    bool help = false;  ///< the list of controls shows
    bool ghost = false;
    bool warns = false;  ///< is warned of what is about to go wrong
    bool stop = false;
    bool try_again = false;
    bool keep_moment = false;
};

/// From what an axis says: fine near the middle, beyond the dead zone. -1 to 1.
double rate_of_stick(double value, const Tuning& tuning);
/// The share of a pedal's travel as the machine takes it: 0, 1 up to the second position, then travel within each. 0
/// to 3.
double pedal_of(double share, const Tuning& tuning);

class Hands {
public:
    /// Stand and script outlive the hands.
    Hands(const Mapping& mapping, const Stand& stand, HoldScript& holds);
    /// Goes on from a state of hands at the same stand.
    Hands(HandsState state, const Stand& stand, HoldScript& holds);

    void take(const UserEvent& event, const Surroundings& around);
    /// From here on a tracking system sees the hands: no cursor, stick or key moves them.
    void track();
    /// Holds what the session's instruments show to be held, where they are; dials as they are set.
    Status take_over(const Session& session, const Surroundings& around);
    /// Time goes on by dt [s]. Fails where the scripts that say how instruments are held do.
    Status advance(const Surroundings& around, double dt);

    /// What each instrument of the scene does.
    [[nodiscard]] std::vector<DeviceSample> samples(const Surroundings& around, double dt) const;
    /// Commands since this was asked last.
    std::vector<Command> take_commands();

    /// Shows a word to the person for a while.
    void tell(const std::string& word);

    /// The clock stands: paused, or the hand has yet to meet its instrument.
    [[nodiscard]] bool waits() const { return state_.paused || !met(); }
    [[nodiscard]] bool met() const;
    /// Its shaft goes through the side port, where a hand takes it up.
    [[nodiscard]] bool through_side_port(int instrument) const {
        return wounds_[static_cast<std::size_t>(instrument)] == "side_port";
    }
    /// All that the hands hold goes this way in the eye's frame: it is the head that moved.
    void shift(const Vec3& way);
    /// A dial has been turned by somebody else.
    void turned_to(const std::string& setting, double value);
    /// From here on the hand has to meet its instrument again.
    void lose();
    [[nodiscard]] const HandsState& state() const { return state_; }
    HandsState& state() { return state_; }
    [[nodiscard]] const Stand& stand() const { return *stand_; }
    [[nodiscard]] const Mapping& mapping() const { return *state_.mapping; }

private:
    void take_device(const UserEvent& event);
    void take_tracking(const UserEvent& event);
    void take_tracked(const UserEvent& event, const Surroundings& around);
    void take_asked(const std::string& text);
    void hold_tracked(int instrument, const Surroundings& around);
    void rebind(const UserEvent& event);
    void take_input(const UserEvent& event, const Surroundings& around);
    void hold(const std::string& source, const Binding& binding, const UserEvent& event);
    void choose(ControlId id, double number, const Surroundings& around);
    void let_go_of_stuck_sticks(double dt);
    void press(ControlId id, double notches, const Surroundings& around);
    void follow_cursor(const Cursor& cursor, const Surroundings& around);
    void turn_dial(int dial, double notches);
    void note_turned(int dial);
    void take_up(int hand, int instrument, const Surroundings& around);
    void put_down(int hand);
    bool take_instrument(int instrument, const Surroundings& around);
    void next_instrument(const Surroundings& around);
    Status move(int hand, const Surroundings& around, double dt);
    void squeeze(int hand, double dt);
    void press_pedal(double dt);
    [[nodiscard]] const std::string& tool_name(int instrument) const {
        return stand_->instruments[static_cast<std::size_t>(instrument)].name;
    }
    [[nodiscard]] double level(ControlId id) const;
    [[nodiscard]] double speed_share() const;
    void choose_wound(const Surroundings& around, HandState& hand) const;

    const Stand* stand_;
    HoldScript* holds_;
    std::vector<std::string> wounds_;  ///< by instrument, the landmark about which virtual surgeons hold it
    HandsState state_;
};

}  // namespace rhexis::station
