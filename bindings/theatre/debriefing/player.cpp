// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/debriefing/player.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/clock.hpp"
#include "session/replay.hpp"
#include "station/theatre.hpp"

namespace rhexis::station {
namespace {

constexpr double shown_every_s = 0.04;  ///< while it is on its way

/// The last one at or before a step; null: there is none.
const Snapshot* checkpoint_before(const Recording& recording, std::uint64_t step) {
    const Snapshot* best = nullptr;
    for (const Snapshot& one : recording.checkpoints) {
        best = one.step <= step ? &one : best;
    }
    return best;
}

}  // namespace

Player::Player(const Recording& recording) : recording_(recording), thread_([this] { run(); }) {}

Player::~Player() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wanted_changed_.notify_all();
    thread_.join();
}

void Player::go_to(std::uint64_t step) {
    {
        const std::lock_guard lock(mutex_);
        wanted_ = std::min<std::uint64_t>(step, recording_.steps.size());
    }
    wanted_changed_.notify_all();
}

std::shared_ptr<const PlayedMoment> Player::newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
}

std::string Player::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

void Player::run() {
    std::optional<Session> session;
    std::optional<PanelReader> reader;
    double shown_s = 0.0;
    const auto show = [&] {
        if (!reader) {
            reader.emplace(session->schema(), session->scene().instruments);
        }
        auto moment = std::make_shared<const PlayedMoment>(
            PlayedMoment{session->frame(), session->step_count(), reader->panel(*session), reader->forces(*session)});
        shown_s = wall_seconds();
        const std::lock_guard lock(mutex_);
        newest_ = std::move(moment);
    };
    for (;;) {
        std::uint64_t wanted = 0;
        {
            std::unique_lock lock(mutex_);
            wanted_changed_.wait(lock, [&] { return ends_ || !session || session->step_count() != wanted_; });
            if (ends_) {
                return;
            }
            wanted = wanted_;
        }
        const Snapshot* before = checkpoint_before(recording_, wanted);
        const std::uint64_t from = before != nullptr ? before->step : 0;
        if (!session || session->step_count() > wanted || session->step_count() < from) {
            Status there = success();
            if (session && before != nullptr) {
                there = session->restore(*before);
            } else {
                Result<Session> made = session_at(recording_, from);
                there = made ? success() : Status(made.error());
                session.reset();
                if (made) {
                    session.emplace(std::move(made).value());
                }
            }
            if (!there) {
                const std::lock_guard lock(mutex_);
                fault_ = there.error().text();
                return;
            }
            show();
            continue;
        }
        const RecordedStep& next = recording_.steps[session->step_count()];
        static_cast<void>(session->step(next.samples, next.commands));  // as it was recorded, whatever it came to
        if (session->step_count() == wanted || wall_seconds() - shown_s > shown_every_s) {
            show();
        }
    }
}

}  // namespace rhexis::station
