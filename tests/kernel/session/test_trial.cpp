// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/trial.hpp"

#include <doctest/doctest.h>

#include <functional>

#include "kernel/session/sessions.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

/// A timeline of numbers: what a trial does with it, without an eye.
class PaperTimeline final : public Timeline {
public:
    [[nodiscard]] const SceneDescription& scene() const override { return scene_; }
    [[nodiscard]] const ObservationSchema& schema() const override { return schema_; }
    [[nodiscard]] const Observation& observation() const override { return observation_; }
    [[nodiscard]] std::uint64_t step_count() const override { return step_; }
    [[nodiscard]] Session* session() override { return nullptr; }
    Result<StepOutcome> advance(std::span<const DeviceSample> samples, std::span<const Command> commands) override {
        given.emplace_back(commands.begin(), commands.end());
        taken.push_back(samples.size());
        observation_.time_s = 0.1 * static_cast<double>(++step_);
        return step_ == broken_at ? Result<StepOutcome>(Error{"the timeline is broken", "", ""}) : StepOutcome{};
    }

    std::vector<std::vector<Command>> given;
    std::vector<std::size_t> taken;
    std::uint64_t broken_at = 0;

private:
    SceneDescription scene_;
    ObservationSchema schema_;
    Observation observation_;
    std::uint64_t step_ = 0;
};

Command command(CommandKind kind, const std::string& name) { return {kind, name, 0.0, ""}; }

/// An exercise that does what a test says, by the number of the moment from 1.
class PaperExercise final : public Exercise {
public:
    Status start(const ObservationSchema&, const std::vector<std::string>&) override { return starts; }
    Result<std::vector<Command>> observe(const Observation&, std::span<const Command> given) override {
        heard.emplace_back(given.begin(), given.end());
        return wants ? wants(heard.size()) : std::vector<Command>{};
    }
    [[nodiscard]] bool finished() const override { return heard.size() >= finished_at; }

    Status starts = success();
    std::function<Result<std::vector<Command>>(std::size_t)> wants;
    std::vector<std::vector<Command>> heard;
    std::size_t finished_at = ~std::size_t{0};
};

/// Somebody who asks for one thing in each step and stops after some.
class PaperHand final : public Operator {
public:
    explicit PaperHand(std::uint64_t steps = ~std::uint64_t{0}) : steps_(steps) {}
    Result<OperatorStep> operate(Timeline& timeline) override {
        if (timeline.step_count() >= steps_) {
            return OperatorStep{.done = true};
        }
        if (timeline.step_count() == fails_at) {
            return Error{"the hand slipped", "plan", ""};
        }
        return OperatorStep{{DeviceSample{}}, {command(CommandKind::request, "drops")}};
    }
    std::uint64_t fails_at = ~std::uint64_t{0};

private:
    std::uint64_t steps_;
};

/// Writes down what it is shown.
class Notes final : public TrialObserver {
public:
    Status begun(Timeline&) override { return say("begun"); }
    Status look(Moment& moment) override {
        moment.stop = ++looks == stop_at;
        if (looks == adds_at) {
            moment.commands.push_back(command(CommandKind::set, "added"));
        }
        if (looks == full_at) {
            return Error{"the disk is full", "", ""};
        }
        return say(moment.last ? "last look" : "look");
    }
    Status ended(Timeline&) override { return say("ended"); }

    std::string said;
    int looks = 0;
    int stop_at = 0;
    int adds_at = 0;
    int full_at = 0;

private:
    Status say(const std::string& what) {
        said += (said.empty() ? "" : ", ") + what;
        return success();
    }
};

struct PaperTrial {
    PaperTimeline timeline;
    PaperExercise exercise;
    PaperHand hand;
    Notes notes;

    TrialOutcome run(TrialLimits limits = {}) {
        const Result<TrialOutcome> outcome = Trial(timeline, &exercise, hand, {&notes}, limits).run();
        REQUIRE_MESSAGE(outcome.ok(), (outcome ? std::string() : outcome.error().text()));
        return outcome.value();
    }
};

std::string names(const std::vector<Command>& commands) {
    std::string text;
    for (const Command& one : commands) {
        text += (text.empty() ? "" : " ") + one.name;
    }
    return text;
}

}  // namespace

TEST_SUITE("trial") {
    TEST_CASE("the exercise judges, others look, somebody acts, the timeline goes on") {
        PaperTrial trial;
        trial.hand = PaperHand(2);
        trial.notes.adds_at = 2;
        trial.exercise.wants = [](std::size_t moment) {
            return std::vector<Command>{command(CommandKind::say, "moment " + std::to_string(moment))};
        };
        CHECK(trial.run().end == TrialEnd::done);
        CHECK(trial.notes.said == "begun, look, look, look, ended");
        CHECK(trial.timeline.taken == std::vector<std::size_t>{1, 1});
        REQUIRE(trial.timeline.given.size() == 2);
        CHECK(names(trial.timeline.given[0]) == "moment 1 drops");
        CHECK(names(trial.timeline.given[1]) == "moment 2 added drops");
        REQUIRE(trial.exercise.heard.size() == 3);
        CHECK(trial.exercise.heard[0].empty());
        CHECK(names(trial.exercise.heard[1]) == "moment 1 drops");
        CHECK(names(trial.exercise.heard[2]) == "moment 2 added drops");
    }

    TEST_CASE("it ends with the exercise, when that asks, or at its limit of time; the last moment is shown as such") {
        PaperTrial over;
        over.exercise.finished_at = 3;
        CHECK(over.run().end == TrialEnd::finished);
        CHECK(over.notes.said == "begun, look, look, last look, ended");
        CHECK(over.timeline.step_count() == 2);

        PaperTrial asked;
        asked.exercise.wants = [](std::size_t moment) {
            return moment == 2 ? std::vector<Command>{command(CommandKind::finish, "")} : std::vector<Command>{};
        };
        CHECK(asked.run().end == TrialEnd::finished);
        CHECK(asked.timeline.step_count() == 1);

        PaperTrial late;
        CHECK(late.run({.time_s = 0.5}).end == TrialEnd::time_up);
        CHECK(late.timeline.step_count() == 5);
    }

    TEST_CASE("a test goes on when the exercise is over") {
        PaperTrial trial;
        trial.exercise.finished_at = 2;
        trial.hand = PaperHand(4);
        CHECK(trial.run({.beyond_the_exercise = true}).end == TrialEnd::done);
        CHECK(trial.timeline.step_count() == 4);
    }

    TEST_CASE("an observer that has what it wanted ends it") {
        PaperTrial trial;
        trial.notes.stop_at = 3;
        CHECK(trial.run().end == TrialEnd::stopped);
        CHECK(trial.timeline.step_count() == 2);
    }

    TEST_CASE("what fails in a script ends the trial as a trial; those who look on are told the end") {
        PaperTrial exercise;
        exercise.exercise.wants = [](std::size_t moment) {
            return moment < 3 ? Result<std::vector<Command>>(std::vector<Command>{}) : Error{"nil", "exercise", ""};
        };
        const TrialOutcome judged = exercise.run();
        CHECK(judged.end == TrialEnd::failed);
        REQUIRE(judged.error);
        CHECK(judged.error->text() == "exercise: nil");
        CHECK(exercise.notes.said == "begun, look, look, ended");

        PaperTrial hand;
        hand.hand.fails_at = 1;
        CHECK(hand.run().error->what == "the hand slipped");
        CHECK(hand.timeline.step_count() == 1);

        PaperTrial unready;
        unready.exercise.starts = Error{"no such measure", "exercise", ""};
        CHECK(unready.run().error->what == "no such measure");
        CHECK(unready.notes.said == "begun, ended");
        CHECK(unready.exercise.heard.empty());
    }

    TEST_CASE("what fails outside the scripts is the trial's own error") {
        PaperTrial full;
        full.notes.full_at = 2;
        const Result<TrialOutcome> stopped = Trial(full.timeline, &full.exercise, full.hand, {&full.notes}).run();
        REQUIRE_FALSE(stopped.ok());
        CHECK(stopped.error().what == "the disk is full");

        PaperTrial broken;
        broken.timeline.broken_at = 2;
        CHECK_FALSE(Trial(broken.timeline, &broken.exercise, broken.hand).run().ok());
    }

    TEST_CASE("without an exercise whoever operates says everything; a session's steps are shown with their cost") {
        class Steps final : public TrialObserver {
        public:
            Status stepped(const TrialStep& step) override {
                ++count;
                last_step = step.session.step_count();
                timed = timed && step.wall_s > 0.0 && step.cpu_s >= 0.0;
                return success();
            }
            int count = 0;
            std::uint64_t last_step = 0;
            bool timed = true;
        } steps;
        Session session = make_session(SceneDescription{});
        LiveTimeline timeline(session);
        Nobody nobody;
        const Result<TrialOutcome> outcome = Trial(timeline, nullptr, nobody, {&steps}, {.time_s = 0.03}).run();
        REQUIRE(outcome.ok());
        CHECK(outcome.value().end == TrialEnd::time_up);
        CHECK(steps.count == 3);
        CHECK(steps.last_step == 3);
        CHECK(steps.timed);
    }
}
