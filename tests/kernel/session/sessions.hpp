// SPDX-License-Identifier: GPL-3.0-or-later
// A session of any scene: made, refused, recorded step by step, replayed.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include "session/replay.hpp"
#include "support/folder.hpp"

namespace rhexis::test {

inline Session make_session(const SceneDescription& scene, std::uint64_t seed = 1) {
    Result<Session> session = Session::create(scene, seed);
    REQUIRE_MESSAGE(session.ok(), session.error().text());
    return std::move(session).value();
}

/// Why there is no session of this scene; "" when there is one.
inline std::string refusal(const SceneDescription& scene) {
    const Result<Session> session = Session::create(scene, 1);
    return session ? "" : session.error().text();
}

/// Records what it hands to a session, in a file of its own, with checkpoints as often as in a run.
class SessionRecorder {
public:
    explicit SessionRecorder(Session& session) : session_(session), writer_(begin(path_, session)) {
        REQUIRE(writer_.add(RecordedStart{session.observation(), session.state_hash()}).ok());
    }

    /// The state of now; needed at the start of a session that does not begin as it was made.
    void add_checkpoint() { REQUIRE(writer_.add(session_.snapshot()).ok()); }

    void step(const DeviceSample& sample) {
        session_.step({&sample, 1}, {});
        const RecordedStep step{session_.step_count(), {sample}, {}, session_.observation(), session_.state_hash()};
        REQUIRE(writer_.add(step).ok());
        if (session_.step_count() % interval() == 0) {
            add_checkpoint();
        }
    }

    /// Steps between two checkpoints.
    [[nodiscard]] std::uint64_t interval() const {
        return static_cast<std::uint64_t>(std::lround(checkpoint_interval_s / session_.scene().step_s));
    }

    [[nodiscard]] Recording finish() {
        REQUIRE(writer_.finish().ok());
        return std::move(read_recording(path_)).value();
    }

private:
    static RecordingWriter begin(const std::string& path, const Session& session) {
        RecordingHeader header = header_of(session);
        header.seed = 1;
        Result<RecordingWriter> created = RecordingWriter::create(path, header);
        REQUIRE(created.ok());
        return std::move(created).value();
    }

    Folder folder_;
    std::string path_ = folder_ / "recording.rhx";
    Session& session_;
    RecordingWriter writer_;
};

/// Simulated again, every step ends in the same state; and so it does from the checkpoint before each of some steps.
inline void check_replays(const Recording& recording, std::initializer_list<std::uint64_t> entered) {
    const Result<Verification> verification = verify(recording, [](std::uint64_t, std::uint64_t) {});
    REQUIRE(verification.ok());
    CHECK(verification.value().steps == recording.steps.size());
    CHECK_FALSE(verification.value().divergence.has_value());
    for (const std::uint64_t step : entered) {
        CHECK(session_at(recording, step).value().state_hash() == recording.steps[step - 1].hash);
    }
}

}  // namespace rhexis::test
