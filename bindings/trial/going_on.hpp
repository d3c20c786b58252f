// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt that goes on from a step of its recording: after it was cut short, or to try again from there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/recording.hpp"
#include "session/trial.hpp"

namespace rhexis {

/// What there is of the attempt: its recording, as far as it goes on from there.
struct GoingOn {
    Recording recording;  ///< nothing after the step
    std::uint64_t step = 0;
};

/// From the last step of a recording, or an earlier one. Fails where there is no such step.
Result<GoingOn> going_on_from(Recording recording, std::uint64_t step);

/// Gives a recording a name of its own, the first of "left_1.rhx", "left_2.rhx" ... that is free, which is returned:
/// what is gone on from is not written over.
Result<std::string> put_aside(const std::string& recording);

/// Lets an exercise see what was recorded before it sees what comes: it then stands where it stood.
class CaughtUp final : public Exercise {
public:
    /// Both outlive it. before: null, there was nothing before.
    CaughtUp(Exercise& exercise, const GoingOn* before) : exercise_(exercise), before_(before) {}
    Status start(const ObservationSchema& schema, const std::vector<std::string>& instruments) override;
    Result<std::vector<Command>> observe(const Observation& observation, std::span<const Command> given) override;
    [[nodiscard]] bool finished() const override { return exercise_.finished(); }

private:
    Exercise& exercise_;
    const GoingOn* before_;
    bool first_ = true;
};

}  // namespace rhexis
