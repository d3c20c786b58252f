// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/film.hpp"

#include <future>
#include <optional>

#include "cli/progress.hpp"
#include "session/replay.hpp"

namespace rhexis::cli {
namespace {

/// A recording simulated from one moment of its video to the next.
class FilmedRun {
public:
    FilmedRun(Session& session, const std::vector<RecordedStep>& steps, FilmClock clock)
        : session_(session), steps_(steps), clock_(clock) {}

    /// The next moment that is on the video; nothing after the last step.
    std::optional<Frame> next() {
        while (done_ < steps_.size()) {
            const RecordedStep& step = steps_[done_++];
            session_.step(step.samples, step.commands);
            if (clock_.wants(session_.time_s())) {
                clock_.advance_beyond(session_.time_s());
                return session_.frame();
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] std::size_t done() const { return done_; }

private:
    Session& session_;
    const std::vector<RecordedStep>& steps_;
    FilmClock clock_;
    std::size_t done_ = 0;
};

Status film(FilmedRun& run, std::size_t steps, PictureBook& book, Progress& progress) {
    std::optional<Frame> now = run.next();
    while (now) {
        const std::size_t done = run.done();
        // Simulated beside the drawing, which has to stay on the thread of its context.
        std::future<std::optional<Frame>> later = std::async(std::launch::async, [&run] { return run.next(); });
        const Status status = book.film(*now);
        now = later.get();
        if (!status) {
            return status;
        }
        progress.show(static_cast<double>(done) / static_cast<double>(steps), "step " + std::to_string(done));
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
    if (status) {
        FilmedRun run(session.value(), recording.steps, book.clock());
        status = film(run, recording.steps.size(), book, progress);
    }
    if (status && stills) {
        status = book.keep(session.value().frame(), "end", "At the end.");
    }
    return status ? book.finish() : status;
}

}  // namespace rhexis::cli
