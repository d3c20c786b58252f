// SPDX-License-Identifier: GPL-3.0-or-later
// A trial's recording, written while it runs.
#pragma once

#include "session/recording.hpp"
#include "session/trial.hpp"

namespace rhexis {

class Recorder final : public TrialObserver {
public:
    /// at_rest: the session begins as its scene makes it, so that no state needs to be kept of its start.
    Recorder(RecordingWriter writer, bool at_rest) : writer_(std::move(writer)), at_rest_(at_rest) {}

    Status begun(Timeline& timeline) override;
    Status stepped(const TrialStep& step) override;
    Status ended(Timeline&) override { return writer_.finish(); }

    /// Where the bytes are now, see RecordingWriter::file.
    [[nodiscard]] const std::string& file() const { return writer_.file(); }

private:
    RecordingWriter writer_;
    bool at_rest_;
    std::uint64_t checkpoint_steps_ = 1;
};

}  // namespace rhexis
