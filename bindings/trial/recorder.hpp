// SPDX-License-Identifier: GPL-3.0-or-later
// A trial's recording, written while it runs by a thread of its own: a checkpoint takes longer than a step may.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>

#include "session/recording.hpp"
#include "session/trial.hpp"
#include "trial/attempt_facts.hpp"
#include "trial/going_on.hpp"

namespace rhexis {

class Recorder final : public TrialObserver {
public:
    /// at_rest: the session begins as its scene makes it, so that no state needs to be kept of its start. before: what
    /// the attempt goes on from, or null; it outlives the recorder.
    Recorder(RecordingWriter writer, bool at_rest, const GoingOn* before = nullptr);
    ~Recorder() override;
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // An error of the writer, a full disk say, is told by the step after it.
    Status begun(Timeline& timeline) override;
    Status stepped(const TrialStep& step) override;
    Status ended(Timeline&) override;

    /// Where the bytes are now, see RecordingWriter::file.
    [[nodiscard]] const std::string& file() const { return writer_.file(); }
    /// After the end.
    [[nodiscard]] const CheckpointCost& checkpoints() const { return checkpoints_; }

private:
    using Entry = std::variant<RecordedStart, RecordedStep, Snapshot>;

    Status give(Entry entry);
    void write();
    void close();

    RecordingWriter writer_;
    bool at_rest_;
    const GoingOn* before_;
    std::uint64_t checkpoint_steps_ = 1;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Entry> waiting_;
    bool closing_ = false;
    std::optional<Error> error_;
    CheckpointCost checkpoints_;  ///< each member by one thread
    std::thread thread_;          ///< the last: it works on all of the above
};

}  // namespace rhexis
