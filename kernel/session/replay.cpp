// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/replay.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

/// Difference relative to the larger of the two; infinite when only one is defined.
double relative_difference(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) {
        return std::isnan(a) == std::isnan(b) ? 0.0 : std::numeric_limits<double>::infinity();
    }
    const double size = std::max(std::abs(a), std::abs(b));
    return size > 0.0 ? std::abs(a - b) / size : 0.0;
}

struct WorstMeasure {
    std::string name;
    double relative = 0.0;
};

WorstMeasure worst_measure(const ObservationSchema& schema, const Observation& a, const Observation& b) {
    WorstMeasure worst;
    for (std::size_t i = 0; i < schema.size(); ++i) {
        const double relative = relative_difference(a.values[i], b.values[i]);
        if (relative > worst.relative) {
            worst = {schema[i].name, relative};
        }
    }
    return worst;
}

bool same_schema(const ObservationSchema& a, const ObservationSchema& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const MeasureInfo& x, const MeasureInfo& y) { return x.name == y.name && x.unit == y.unit; });
}

/// Holds each step against the one that was recorded.
class Comparison final : public TrialObserver {
public:
    Comparison(const Recording& recording, const ReplayProgress& progress)
        : recording_(recording), progress_(progress) {}

    Status begun(Timeline& timeline) override {
        compare(0, recording_.start.hash, recording_.start.observation, *timeline.session());
        return success();
    }
    Status stepped(const TrialStep& step) override {
        const RecordedStep& recorded = recording_.steps[result_.steps];
        compare(recorded.step, recorded.hash, recorded.observation, step.session);
        ++result_.steps;
        progress_(recorded.step, recording_.steps.size());
        return success();
    }
    [[nodiscard]] const Verification& result() const { return result_; }

private:
    void compare(std::uint64_t step, std::uint64_t hash, const Observation& recorded, const Session& session) {
        if (session.state_hash() == hash && !result_.divergence) {
            return;
        }
        const WorstMeasure worst = worst_measure(session.schema(), recorded, session.observation());
        result_.worst_measure = std::max(result_.worst_measure, worst.relative);
        if (!result_.divergence) {
            result_.divergence = Divergence{step, hash, session.state_hash(), worst.name, worst.relative};
        }
    }

    const Recording& recording_;
    const ReplayProgress& progress_;
    Verification result_;
};

}  // namespace

Result<Session> session_of(const Recording& recording) {
    Result<Session> session = Session::create(recording.header.scene, recording.header.seed);
    if (session && !same_schema(session.value().schema(), recording.header.schema)) {
        return Error{"the recording was made by a program with other measures (" + recording.header.build + ")",
                     "recording", "replay it with that program"};
    }
    if (session && !recording.checkpoints.empty() && recording.checkpoints.front().step == 0) {
        const Status restored = session.value().restore(recording.checkpoints.front());
        if (!restored) {
            return restored.error();
        }
    }
    return session;
}

Result<Session> session_at(const Recording& recording, std::uint64_t step) {
    if (step > recording.steps.size()) {
        return Error{"there is no step " + std::to_string(step), "recording",
                     "0 to " + std::to_string(recording.steps.size())};
    }
    Result<Session> session = session_of(recording);
    if (!session) {
        return session;
    }
    const auto after = std::find_if(recording.checkpoints.begin(), recording.checkpoints.end(),
                                    [&](const Snapshot& snapshot) { return snapshot.step > step; });
    if (after != recording.checkpoints.begin()) {
        const Status status = session.value().restore(*(after - 1));
        if (!status) {
            return status.error();
        }
    }
    LiveTimeline timeline(session.value());
    RecordedHand hand(recording, RecordedHand::Gives::all, step);
    const Result<TrialOutcome> played = Trial(timeline, nullptr, hand).run();
    return played ? std::move(session) : Result<Session>(played.error());
}

Result<Verification> verify(const Recording& recording, const ReplayProgress& progress) {
    Result<Session> created = session_of(recording);
    if (!created) {
        return created.error();
    }
    LiveTimeline timeline(created.value());
    RecordedHand hand(recording);
    Comparison comparison(recording, progress);
    const Result<TrialOutcome> played = Trial(timeline, nullptr, hand, {&comparison}).run();
    return played ? Result<Verification>(comparison.result()) : played.error();
}

Result<OperatorStep> RecordedHand::operate(Timeline& timeline) {
    const std::uint64_t step = timeline.step_count();
    if (step >= std::min<std::uint64_t>(last_, recording_.steps.size())) {
        return OperatorStep{.done = true};
    }
    const RecordedStep& recorded = recording_.steps[step];
    OperatorStep again{recorded.samples, recorded.commands};
    if (gives_ == Gives::input) {
        std::erase_if(again.commands, [](const Command& command) { return !is_input(command); });
    }
    return again;
}

}  // namespace rhexis
