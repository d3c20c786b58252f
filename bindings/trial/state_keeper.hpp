// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a state of a trial, to start others from; the trial goes on as if nothing had been kept.
#pragma once

#include <optional>
#include <string>

#include "lua/exercise_host.hpp"
#include "session/recording.hpp"

namespace rhexis {

/// Which state is kept, and where.
struct SaveOptions {
    std::string path;    ///< empty: none
    double at_s = -1.0;  ///< at this simulated time; below 0: see `when`
    std::string when;    ///< as soon as this condition of the exercise holds; empty (and no time): at the end
};

class StateKeeper final : public TrialObserver {
public:
    StateKeeper(SaveOptions options, ExerciseHost& host, RecordingHeader header)
        : options_(std::move(options)), host_(host), header_(std::move(header)) {}

    Status begun(Timeline& timeline) override;
    Status look(Moment& moment) override;

    [[nodiscard]] bool kept() const { return kept_; }
    /// What is wrong with the condition; it ends the trial.
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    bool reached(const Moment& moment);

    SaveOptions options_;
    ExerciseHost& host_;
    RecordingHeader header_;
    std::optional<Error> error_;
    bool kept_ = false;
};

}  // namespace rhexis
