// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"

namespace rhexis {
namespace {

constexpr std::size_t most_waiting = 500;  ///< entries: where the disk is slower than the trial, the trial waits

}  // namespace

Recorder::Recorder(RecordingWriter writer, bool at_rest, const GoingOn* before)
    : writer_(std::move(writer)), at_rest_(at_rest), before_(before), thread_([this] { write(); }) {}

Recorder::~Recorder() { close(); }

Status Recorder::begun(Timeline& timeline) {
    const Session& session = *timeline.session();
    checkpoint_steps_ = static_cast<std::uint64_t>(std::lround(checkpoint_interval_s / session.scene().step_s));
    if (before_ == nullptr) {
        const Status status = at_rest_ ? success() : give(session.copy_state());
        return status ? give(RecordedStart{session.observation(), session.state_hash()}) : status;
    }
    const Recording& recording = before_->recording;
    auto checkpoint = recording.checkpoints.begin();
    Status status = success();
    const auto give_checkpoints = [&](std::uint64_t step) {
        for (; status && checkpoint != recording.checkpoints.end() && checkpoint->step == step; ++checkpoint) {
            status = give(*checkpoint);
        }
    };
    give_checkpoints(0);
    status = status ? give(recording.start) : status;
    for (const RecordedStep& step : recording.steps) {
        status = status ? give(step) : status;
        give_checkpoints(step.step);
    }
    return status;
}

Status Recorder::stepped(const TrialStep& step) {
    const Session& session = step.session;
    const Status status = give(RecordedStep{session.step_count(),
                                            {step.samples.begin(), step.samples.end()},
                                            {step.commands.begin(), step.commands.end()},
                                            session.observation(),
                                            session.state_hash()});
    if (!status || session.step_count() % checkpoint_steps_ != 0) {
        return status;
    }
    const double begun = wall_seconds();
    Status given = give(session.snapshot());
    ++checkpoints_.count;
    checkpoints_.worst_taking_ms = std::max(checkpoints_.worst_taking_ms, 1e3 * (wall_seconds() - begun));
    return given;
}

Status Recorder::ended(Timeline&) {
    close();
    return error_ ? Status(*error_) : writer_.finish();
}

Status Recorder::give(Entry entry) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < most_waiting || error_; });
    if (error_) {
        return *error_;
    }
    waiting_.push_back(std::move(entry));
    changed_.notify_all();
    return success();
}

/// On the thread of its own.
void Recorder::write() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
        if (waiting_.empty()) {
            return;
        }
        const Entry entry = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        const double begun = wall_seconds();
        const Status written = std::visit([this](const auto& one) { return writer_.add(one); }, entry);
        if (std::holds_alternative<Snapshot>(entry)) {
            checkpoints_.worst_writing_ms = std::max(checkpoints_.worst_writing_ms, 1e3 * (wall_seconds() - begun));
        }
        lock.lock();
        if (!written && !error_) {
            error_ = written.error();
        }
        changed_.notify_all();
    }
}

/// All that was given is written.
void Recorder::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable()) {
        thread_.join();
    }
}

}  // namespace rhexis
