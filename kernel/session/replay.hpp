// SPDX-License-Identifier: GPL-3.0-or-later
// A recording simulated again: does every step end in the state that was recorded?
#pragma once

#include <functional>
#include <optional>

#include "session/recording.hpp"
#include "session/trial.hpp"

namespace rhexis {

struct Divergence {
    std::uint64_t step = 0;      ///< first step that ended differently; 0: already the start
    std::uint64_t recorded = 0;  ///< hash
    std::uint64_t simulated = 0;
    std::string measure;    ///< measure that differs most then, relative to its size; empty: none
    double relative = 0.0;  ///< by how much
};

struct Verification {
    std::uint64_t steps = 0;  ///< compared
    std::optional<Divergence> divergence;
    /// Greatest relative difference of any measure in any step; only filled after a divergence.
    double worst_measure = 0.0;
};

/// Does again what was recorded, up to a step; past the last one, all.
class RecordedHand final : public Operator {
public:
    enum class Gives {
        all,   ///< samples and commands: nothing judges
        input  ///< samples, what was asked of the staff and the dials turned: the exercise says the rest anew
    };
    explicit RecordedHand(const Recording& recording, Gives gives = Gives::all, std::uint64_t last = ~std::uint64_t{0})
        : recording_(recording), gives_(gives), last_(last) {}
    Result<OperatorStep> operate(Timeline& timeline) override;

private:
    const Recording& recording_;
    Gives gives_;
    std::uint64_t last_;
};

/// Called after each step.
using ReplayProgress = std::function<void(std::uint64_t step, std::uint64_t of)>;

/// A session in the state before the first step of the recording.
Result<Session> session_of(const Recording& recording);

/// The session as it was after a recorded step: restored at the last checkpoint before it and stepped from there.
/// step: 0 to the number of steps.
Result<Session> session_at(const Recording& recording, std::uint64_t step);

/// Simulates from the start with the recorded samples and commands. Threads and instruction set are those of the
/// recording's scene: change them there to verify with others.
Result<Verification> verify(const Recording& recording, const ReplayProgress& progress);

}  // namespace rhexis
