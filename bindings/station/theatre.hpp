// SPDX-License-Identifier: GPL-3.0-or-later
// The theatre around the window: a monitor that shows each moment, and an instructor at it. What is shown goes one way;
// what the instructor asks for comes as events (EventKind::staff), and from there as recorded commands.
#pragma once

#include <string>

#include "flow/observation.hpp"
#include "lua/exercise_host.hpp"
#include "session/session.hpp"
#include "station/theatre_moment.hpp"

namespace rhexis::station {

/// The address of this user on this computer; the folder that it lies in belongs to this user alone.
std::string usual_theatre();

/// Takes moments. Never waits for whoever shows them.
class Theatre {
public:
    virtual ~Theatre() = default;
    virtual void show(const TheatreMoment& moment) = 0;
};

/// Reads the machine's panel and the forces of a scene's observations by name.
class PanelReader {
public:
    PanelReader(const ObservationSchema& schema, const std::vector<std::string>& instruments);
    [[nodiscard]] MachinePanel panel(const Session& session) const;
    [[nodiscard]] std::vector<HandForce> forces(const Session& session) const;

private:
    struct Force {
        std::string instrument;
        std::string meaning;
        int measure = -1;
        int present = -1;
    };
    struct Machine {
        std::string instrument;
        int present = -1, pedal = -1, power = -1, cde = -1, occlusion = -1;
    };

    std::vector<Force> forces_;
    std::vector<Machine> machines_;  ///< instruments with a pedal
    int vacuum_ = -1, flow_ = -1, chamber_share_ = -1, depth_lost_ = -1;
};

/// What the exercise tells of this moment: steps, events, warnings, vitals, and with `score` the points so far; the
/// rest of the moment stays as it was.
Status tell_exercise(ExerciseHost& host, bool score, TheatreMoment& moment);

}  // namespace rhexis::station
