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

void compare(const ObservationSchema& schema, std::uint64_t step, std::uint64_t hash, const Observation& recorded,
             const Session& session, Verification& result) {
    if (session.state_hash() == hash && !result.divergence) {
        return;
    }
    const WorstMeasure worst = worst_measure(schema, recorded, session.observation());
    result.worst_measure = std::max(result.worst_measure, worst.relative);
    if (!result.divergence) {
        result.divergence = Divergence{step, hash, session.state_hash(), worst.name, worst.relative};
    }
}

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
    while (session.value().step_count() < step) {
        const RecordedStep& recorded = recording.steps[session.value().step_count()];
        session.value().step(recorded.samples, recorded.commands);
    }
    return session;
}

Result<Verification> verify(const Recording& recording, const ReplayProgress& progress) {
    Result<Session> created = session_of(recording);
    if (!created) {
        return created.error();
    }
    Session& session = created.value();
    Verification result;
    compare(session.schema(), 0, recording.start.hash, recording.start.observation, session, result);
    for (const RecordedStep& recorded : recording.steps) {
        session.step(recorded.samples, recorded.commands);
        compare(session.schema(), recorded.step, recorded.hash, recorded.observation, session, result);
        ++result.steps;
        progress(recorded.step, recording.steps.size());
    }
    return result;
}

}  // namespace rhexis
