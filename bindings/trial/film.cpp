// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/film.hpp"

#include <future>
#include <optional>

#include "session/replay.hpp"
#include "trial/progress.hpp"

namespace rhexis {
namespace {

/// A recording simulated from one moment of its video to the next.
class FilmedRun {
public:
    FilmedRun(Session& session, const Recording& recording, FilmClock clock)
        : timeline_(session), hand_(recording), trial_(timeline_, nullptr, hand_), clock_(clock) {}

    Status begin() { return trial_.begin(); }
    /// The next moment that is on the video; nothing after the last step.
    Result<std::optional<Frame>> next() {
        for (;;) {
            const Result<bool> stepped = trial_.step();
            if (!stepped || !stepped.value()) {
                return stepped ? Result<std::optional<Frame>>(std::nullopt) : stepped.error();
            }
            const Session& session = *timeline_.session();
            if (clock_.wants(session.time_s())) {
                clock_.advance_beyond(session.time_s());
                return std::optional<Frame>(session.frame());
            }
        }
    }
    [[nodiscard]] std::size_t done() const { return timeline_.step_count(); }

private:
    LiveTimeline timeline_;
    RecordedHand hand_;
    Trial trial_;
    FilmClock clock_;
};

Status film(FilmedRun& run, std::size_t steps, PictureBook& book, Progress& progress) {
    Result<std::optional<Frame>> now = run.next();
    while (now && now.value()) {
        const std::size_t done = run.done();
        // Simulated beside the drawing, which has to stay on the thread of its context.
        std::future<Result<std::optional<Frame>>> later = std::async(std::launch::async, [&run] { return run.next(); });
        const Status status = book.film(*now.value());
        now = later.get();
        if (!status) {
            return status;
        }
        progress.show(static_cast<double>(done) / static_cast<double>(steps), "step " + std::to_string(done));
    }
    return now ? success() : Status(now.error());
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
        FilmedRun run(session.value(), recording, book.clock());
        status = run.begin();
        status = status ? film(run, recording.steps.size(), book, progress) : status;
    }
    if (status && stills) {
        status = book.keep(session.value().frame(), "end", "At the end.");
    }
    return status ? book.finish() : status;
}

}  // namespace rhexis
