// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/film.hpp"

#include "cli/progress.hpp"
#include "session/replay.hpp"

namespace rhexis::cli {

Status film_recording(const Recording& recording, PictureBook& book, bool stills, bool quiet,
                      const std::string& label) {
    Result<Session> session = session_of(recording);
    if (!session) {
        return session.error();
    }
    Progress progress(label, quiet);
    Status status = stills ? book.keep(session.value().frame(), "start", "Before the first step.") : success();
    for (const RecordedStep& step : recording.steps) {
        session.value().step(step.samples, step.commands);
        if (status && book.wants_film(session.value().time_s())) {
            status = book.film(session.value().frame());
        }
        if (!status) {
            return status;
        }
        progress.show(static_cast<double>(step.step) / static_cast<double>(recording.steps.size()),
                      "step " + std::to_string(step.step));
    }
    status = stills ? book.keep(session.value().frame(), "end", "At the end.") : success();
    return status ? book.finish() : status;
}

}  // namespace rhexis::cli
