// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/film.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "cli/progress.hpp"
#include "session/replay.hpp"

namespace rhexis::cli {
namespace {

constexpr std::size_t most_waiting = 8;  ///< moments that are simulated and not yet drawn

struct Moment {
    Frame frame;
    std::uint64_t step = 0;
};

/// Moments on their way from the thread that simulates to the one that draws.
class Moments {
public:
    /// Waits for room. False once nobody takes any more.
    bool put(Moment moment) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return ended_ || waiting_.size() < most_waiting; });
        if (ended_) {
            return false;
        }
        waiting_.push_back(std::move(moment));
        changed_.notify_all();
        return true;
    }
    /// The next one, or nothing after the last.
    std::optional<Moment> take() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
        if (waiting_.empty()) {
            return std::nullopt;
        }
        std::optional<Moment> next(std::move(waiting_.front()));
        waiting_.pop_front();
        changed_.notify_all();
        return next;
    }
    void end() {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Moment> waiting_;
    bool ended_ = false;
};

void simulate(Session& session, const Recording& recording, FilmClock clock, Moments& moments) {
    for (const RecordedStep& step : recording.steps) {
        session.step(step.samples, step.commands);
        const double now = session.time_s();
        if (clock.wants(now) && !moments.put({session.frame(), step.step})) {
            break;
        }
        while (clock.wants(now)) {
            clock.advance();
        }
    }
    moments.end();
}

Status draw(Moments& moments, std::size_t steps, PictureBook& book, Progress& progress) {
    while (const std::optional<Moment> moment = moments.take()) {
        if (Status status = book.film(moment->frame); !status) {
            return status;
        }
        progress.show(static_cast<double>(moment->step) / static_cast<double>(steps),
                      "step " + std::to_string(moment->step));
    }
    return success();
}

}  // namespace

Status film_recording(const Recording& recording, PictureBook& book, bool stills, bool quiet,
                      const std::string& label) {
    Result<Session> session = session_of(recording);
    if (!session) {
        return session.error();
    }
    Progress progress(label, quiet);
    Status status = stills ? book.keep(session.value().frame(), "start", "Before the first step.") : success();
    if (!status) {
        return status;
    }
    // Simulated beside the drawing, which has to stay on the thread of its context.
    Moments moments;
    std::thread simulation([&] { simulate(session.value(), recording, book.clock(), moments); });
    status = draw(moments, recording.steps.size(), book, progress);
    moments.end();
    simulation.join();
    if (status && stills) {
        status = book.keep(session.value().frame(), "end", "At the end.");
    }
    return status ? book.finish() : status;
}

}  // namespace rhexis::cli
