// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/trial.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"

namespace rhexis {
namespace {

constexpr double time_rounding_s = 1e-9;

bool asks_to_finish(const std::vector<Command>& commands) {
    return std::any_of(commands.begin(), commands.end(),
                       [](const Command& command) { return command.kind == CommandKind::finish; });
}

/// With one thread its own, so that others of the process do not count.
double cpu_seconds(const Timeline& timeline) {
    return timeline.scene().threads == 1 ? thread_cpu_seconds() : process_cpu_seconds();
}

}  // namespace

bool Timeline::has_come_to(double time_s) const { return observation().time_s + time_rounding_s >= time_s; }

Status status_of(const Result<TrialOutcome>& outcome) {
    if (!outcome) {
        return outcome.error();
    }
    return outcome.value().error ? Status(*outcome.value().error) : success();
}

Trial::Trial(Timeline& timeline, Exercise* exercise, Operator& whoever, std::vector<TrialObserver*> observers,
             TrialLimits limits)
    : timeline_(timeline), exercise_(exercise), operator_(whoever), observers_(std::move(observers)), limits_(limits) {}

Result<TrialOutcome> Trial::run() {
    Status status = begin();
    bool on = status.ok();
    while (status && on) {
        const Result<bool> stepped = step();
        status = stepped ? success() : Status(stepped.error());
        on = stepped && stepped.value();
    }
    status = status ? end() : status;
    return status ? Result<TrialOutcome>(outcome_) : status.error();
}

Status Trial::begin() {
    Status ready =
        exercise_ != nullptr ? exercise_->start(timeline_.schema(), timeline_.scene().instruments) : success();
    ready = ready ? operator_.begin(timeline_) : ready;
    if (!ready) {
        fail(ready.error());
    }
    for (TrialObserver* observer : observers_) {
        if (Status status = observer->begun(timeline_); !status) {
            return status;
        }
    }
    return success();
}

Result<bool> Trial::step() {
    judge();
    if (outcome_.end == TrialEnd::failed) {
        return false;
    }
    outcome_.end = ended();
    if (const Status shown = show(); !shown) {
        return shown.error();
    }
    return outcome_.end == TrialEnd::none ? act() : Result<bool>(false);
}

Status Trial::end() {
    for (TrialObserver* observer : observers_) {
        if (Status status = observer->ended(timeline_); !status) {
            return status;
        }
    }
    return success();
}

void Trial::judge() {
    if (exercise_ == nullptr || outcome_.end == TrialEnd::failed) {
        commands_.clear();
        return;
    }
    Result<std::vector<Command>> wanted = exercise_->observe(timeline_.observation(), commands_);
    commands_.clear();
    if (wanted) {
        commands_ = std::move(wanted).value();
    } else {
        fail(wanted.error());
    }
}

TrialEnd Trial::ended() const {
    if (exercise_ != nullptr && !limits_.beyond_the_exercise && (exercise_->finished() || asks_to_finish(commands_))) {
        return TrialEnd::finished;
    }
    return timeline_.has_come_to(limits_.time_s) ? TrialEnd::time_up : TrialEnd::none;
}

Status Trial::show() {
    Moment moment{timeline_, commands_, outcome_.end != TrialEnd::none};
    for (TrialObserver* observer : observers_) {
        if (Status status = observer->look(moment); !status) {
            return status;
        }
    }
    if (moment.stop && outcome_.end == TrialEnd::none) {
        outcome_.end = TrialEnd::stopped;
    }
    return success();
}

Result<bool> Trial::act() {
    Result<OperatorStep> wanted = operator_.operate(timeline_);
    if (!wanted) {
        return fail(wanted.error());
    }
    OperatorStep& step = wanted.value();
    if (step.done) {
        outcome_.end = TrialEnd::done;
        return false;
    }
    commands_.insert(commands_.end(), step.commands.begin(), step.commands.end());
    const double wall = wall_seconds();
    const double cpu = cpu_seconds(timeline_);
    const Result<StepOutcome> stepped = timeline_.advance(step.samples, commands_);
    if (!stepped) {
        return stepped.error();
    }
    Session* session = timeline_.session();
    if (session == nullptr) {
        return true;
    }
    const TrialStep made{*session,        step.samples,          commands_,
                         stepped.value(), wall_seconds() - wall, cpu_seconds(timeline_) - cpu};
    for (TrialObserver* observer : observers_) {
        if (Status status = observer->stepped(made); !status) {
            return status.error();
        }
    }
    const Status taken = operator_.stepped(*session, stepped.value());
    return taken ? Result<bool>(true) : fail(taken.error());
}

/// False, as the step that does not follow.
bool Trial::fail(const Error& error) {
    outcome_ = {TrialEnd::failed, error};
    return false;
}

}  // namespace rhexis
