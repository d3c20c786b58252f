// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual surgeon in a person's place: what it would do comes as keys, buttons, cursor and axes.
#pragma once

#include <memory>
#include <optional>

#include "lua/exercise_host.hpp"
#include "station/event_source.hpp"
#include "station/fingers.hpp"
#include "station/typist.hpp"

namespace rhexis::station {

class Scripted final : public EventSource {
public:
    /// options: of the exercise, with the surgeon. clock: null, steps follow each other as they may. typist: null, what
    /// is done is taken as it is; needs a clock.
    static Result<std::unique_ptr<Scripted>> create(const ExerciseOptions& options, const Fingers& fingers,
                                                    std::unique_ptr<WallClock> clock, std::unique_ptr<Typist> typist);

    Result<std::vector<UserEvent>> take(std::uint64_t step, bool waits, const Hands& hands, const Surroundings& around,
                                        const Session& session) override;
    [[nodiscard]] double slowed() const override { return clock_ ? clock_->slowed() : 1.0; }
    [[nodiscard]] std::uint64_t last_number() const override { return clock_ ? clock_->last_number() : 0; }
    [[nodiscard]] bool over() const override { return asked_twice_ && !typist_; }
    [[nodiscard]] std::optional<Pace> pace() const override { return clock_ ? clock_->pace() : std::nullopt; }

private:
    Scripted(ExerciseHost host, const Fingers& fingers, std::unique_ptr<WallClock> clock,
             std::unique_ptr<Typist> typist)
        : host_(std::move(host)), fingers_(fingers), clock_(std::move(clock)), typist_(std::move(typist)) {}

    Result<std::vector<UserEvent>> work(const Hands& hands, const Surroundings& around, const Session& session);

    ExerciseHost host_;
    Fingers fingers_;
    std::unique_ptr<WallClock> clock_;
    std::unique_ptr<Typist> typist_;
    bool begun_ = false;
    std::optional<std::uint64_t> last_step_;
    bool asked_twice_ = false;  ///< for one step: what it did did not end the wait
};

}  // namespace rhexis::station
