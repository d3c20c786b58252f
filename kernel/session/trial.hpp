// SPDX-License-Identifier: GPL-3.0-or-later
// A trial: a session, an exercise that judges, somebody who operates, others who look on. This is the one loop that
// steps a session: a run, a test, a replay, a film and the trainee's window differ in what they put into it.
//
//   the exercise sees the observation and says what it wants    (stage 6)
//   those who look on see that moment
//   whoever operates acts
//   the session steps                                           (stages 0 to 5)
//   those who look on see the step
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "session/session.hpp"

namespace rhexis {

/// What a trial goes through, step by step.
class Timeline {
public:
    virtual ~Timeline() = default;
    [[nodiscard]] virtual const SceneDescription& scene() const = 0;
    [[nodiscard]] virtual const ObservationSchema& schema() const = 0;
    [[nodiscard]] virtual const Observation& observation() const = 0;
    [[nodiscard]] virtual std::uint64_t step_count() const = 0;
    /// Whether simulated time has come to time_s, but for rounding.
    [[nodiscard]] bool has_come_to(double time_s) const;
    /// Null while nothing is simulated.
    [[nodiscard]] virtual Session* session() = 0;
    /// Fails where it cannot go on at all; a step that could not be solved is an outcome.
    virtual Result<StepOutcome> advance(std::span<const DeviceSample> samples, std::span<const Command> commands) = 0;
};

/// A session that is stepped.
class LiveTimeline final : public Timeline {
public:
    /// The session outlives the timeline.
    explicit LiveTimeline(Session& session) : session_(session) {}
    [[nodiscard]] const SceneDescription& scene() const override { return session_.scene(); }
    [[nodiscard]] const ObservationSchema& schema() const override { return session_.schema(); }
    [[nodiscard]] const Observation& observation() const override { return session_.observation(); }
    [[nodiscard]] std::uint64_t step_count() const override { return session_.step_count(); }
    [[nodiscard]] Session* session() override { return &session_; }
    Result<StepOutcome> advance(std::span<const DeviceSample> samples, std::span<const Command> commands) override {
        return session_.step(samples, commands);
    }

private:
    Session& session_;
};

/// Watches, judges and reacts: the curriculum.
class Exercise {
public:
    virtual ~Exercise() = default;
    /// Once, before the first step.
    virtual Status start(const ObservationSchema& schema, const std::vector<std::string>& instruments) = 0;
    /// given: commands of the step that led to this observation. What it wants of the next step.
    virtual Result<std::vector<Command>> observe(const Observation& observation, std::span<const Command> given) = 0;
    [[nodiscard]] virtual bool finished() const = 0;
};

/// What whoever operates does in one step.
struct OperatorStep {
    std::vector<DeviceSample> samples{};
    std::vector<Command> commands{};  ///< requests of the staff; of a test and a recording, settings too
    bool done = false;                ///< has nothing more to do: there is no such step
};

class Operator {
public:
    virtual ~Operator() = default;
    /// Once, before the first step and after the exercise.
    virtual Status begin(Timeline&) { return success(); }
    virtual Result<OperatorStep> operate(Timeline& timeline) = 0;
    /// How the step that it asked for went.
    virtual Status stepped(const Session&, const StepOutcome&) { return success(); }
};

/// Between two steps, when the exercise has judged.
struct Moment {
    Timeline& timeline;
    std::vector<Command>& commands;  ///< what the exercise wants; an observer may add, and that is recorded as the same
    bool last = false;               ///< no step follows
    bool stop = false;               ///< set by an observer: it has what it wanted
};

/// A step that a session has made.
struct TrialStep {
    Session& session;
    std::span<const DeviceSample> samples;
    std::span<const Command> commands;
    const StepOutcome& outcome;
    double wall_s = 0.0;  ///< of the step alone
    double cpu_s = 0.0;   ///< of all its threads
};

/// Looks on, and changes nothing that is simulated. An error ends the trial: a disk that is full.
class TrialObserver {
public:
    virtual ~TrialObserver() = default;
    /// Before the first step, when exercise and operator have begun.
    virtual Status begun(Timeline&) { return success(); }
    virtual Status look(Moment&) { return success(); }
    virtual Status stepped(const TrialStep&) { return success(); }
    /// Once, after the last moment.
    virtual Status ended(Timeline&) { return success(); }
};

enum class TrialEnd {
    none,      ///< it goes on
    finished,  ///< the exercise is over, or asked to be
    time_up,   ///< the limit of simulated time is reached
    done,      ///< whoever operates has nothing more to do
    stopped,   ///< an observer has what it wanted
    failed     ///< exercise or operator: see TrialOutcome::error
};

struct TrialOutcome {
    TrialEnd end = TrialEnd::none;
    std::optional<Error> error{};  ///< of exercise or operator
};

/// For whom a script that fails is a failure like any other.
Status status_of(const Result<TrialOutcome>& outcome);

struct TrialLimits {
    double time_s = std::numeric_limits<double>::infinity();  ///< simulated
    bool beyond_the_exercise = false;                         ///< goes on when the exercise is over
};

class Trial {
public:
    /// exercise: null, nothing judges. All outlive the trial; observers are asked in their order.
    Trial(Timeline& timeline, Exercise* exercise, Operator& whoever, std::vector<TrialObserver*> observers = {},
          TrialLimits limits = {});

    /// From the first moment to the last. Fails where the timeline or an observer does.
    Result<TrialOutcome> run();

    // The same in pieces, for those who do something in between: begin, then step as long as it is true, then end.
    Status begin();
    /// One moment and the step after it. False: it was the last moment.
    Result<bool> step();
    Status end();
    [[nodiscard]] const TrialOutcome& outcome() const { return outcome_; }

private:
    void judge();
    Status show();
    Result<bool> act();
    [[nodiscard]] TrialEnd ended() const;
    bool fail(const Error& error);

    Timeline& timeline_;
    Exercise* exercise_;
    Operator& operator_;
    std::vector<TrialObserver*> observers_;
    TrialLimits limits_;
    std::vector<Command> commands_;  ///< of the exercise, then of whoever operates: what the session was given last
    TrialOutcome outcome_;
};

/// Nobody operates.
class Nobody final : public Operator {
public:
    Result<OperatorStep> operate(Timeline&) override { return OperatorStep{}; }
};

}  // namespace rhexis
