// SPDX-License-Identifier: GPL-3.0-or-later
// An instructor at the theatre's monitor: what is asked for there becomes causes in the eye and at the machine, notes
// on the clock, and a clock that stands or goes back. All of it is recorded as input.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "flow/device_sample.hpp"
#include "lua/exercise_host.hpp"
#include "station/hands.hpp"
#include "station/injector.hpp"
#include "station/theatre_moment.hpp"

namespace rhexis::station {

class Instructor {
public:
    Instructor() = default;
    /// The host outlives the instructor.
    static Result<Instructor> create(ExerciseHost& host, bool has_microscope);

    /// An event of the kind `staff`. What cannot be done is told to the hands, and goes on without it.
    void heed(const UserEvent& event, Hands& hands, const Surroundings& around);

    /// Time goes on by dt [s]: the head moves under the hands, dials turn. What is to be commanded.
    std::vector<Command> advance(double dt, const Session& session, Hands& hands);
    /// The head and a push move the microscope, which is the last of the samples where the scene has one. After
    /// advance.
    void move_microscope(const Surroundings& around, std::vector<DeviceSample>& samples);

    /// By how much the attempt is to go back [s]; asked once.
    std::optional<double> take_rewind() { return std::exchange(rewind_s_, std::nullopt); }

    [[nodiscard]] std::vector<TheatreInjection> injections() const;
    [[nodiscard]] const std::vector<std::string>& levels() const { return levels_; }

private:
    void set_level(const std::string& level, Hands& hands);

    ExerciseHost* host_ = nullptr;
    Injector injector_;
    std::vector<std::string> levels_;
    std::vector<Command> commands_;  ///< to be given with the next step
    Vec3 head_way_ = Vec3::Zero();   ///< of the last step [mm]
    std::optional<Vec3> microscope_goal_;
    std::optional<double> rewind_s_;
};

}  // namespace rhexis::station
