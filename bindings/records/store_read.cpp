// SPDX-License-Identifier: GPL-3.0-or-later
// What is read back from the store.
#include <sys/stat.h>

#include <ctime>
#include <filesystem>

#include "records/process_mark.hpp"
#include "records/store_parts.hpp"

namespace rhexis::records {
namespace {

using soci::into;
using soci::row;
using soci::rowset;
using soci::use;

std::optional<double> number_in(const row& r, const char* column) {
    return r.get_indicator(column) == soci::i_null ? std::nullopt : std::optional<double>(r.get<double>(column));
}

/// Whether the recording of a run still grows: of a process that cannot be looked at, all there is to go by.
bool still_written(const std::string& folder) {
    constexpr std::time_t silence_s = 60;
    struct stat about {};
    const std::string file = folder + "/recording.rhx.part";
    return ::stat(file.c_str(), &about) == 0 && std::time(nullptr) - about.st_mtime < silence_s;
}

AttemptState state_of(const row& r) {
    if (r.get<int>("finished") != 0) {
        return AttemptState::finished;
    }
    switch (life_of(r.get<std::string>("process"))) {
        case Life::alive:
            return AttemptState::running;
        case Life::gone:
            return AttemptState::interrupted;
        case Life::unknown:
            break;
    }
    return still_written(r.get<std::string>("folder")) ? AttemptState::running : AttemptState::interrupted;
}

Attempt attempt_in(const row& r) {
    Attempt a;
    const auto text = [&r](const char* column) { return r.get<std::string>(column); };
    a.id = text("attempt");
    a.trainee = {text("trainee"), text("cohort"), text("arm")};
    a.exercise = text("exercise");
    a.title = text("title");
    a.version = r.get<double>("version");
    a.sha256 = text("sha256");
    a.surgeon = text("surgeon");
    a.seed = std::strtoull(text("seed").c_str(), nullptr, 10);
    a.begun = text("begun");
    a.process = text("process");
    a.folder = text("folder");
    a.state = state_of(r);
    a.ended = text("ended");
    a.completed = r.get<int>("completed") != 0;
    a.duration_s = r.get<double>("duration_s");
    a.patient = text("patient");
    a.settings = text("settings");
    a.level = text("level");
    a.mode = text("mode");
    a.language = text("language");
    a.rubric = text("rubric");
    a.total = number_in(r, "total");
    a.max = number_in(r, "max");
    a.scaled = number_in(r, "scaled");
    a.error = text("error");
    a.recording_sha256 = text("recording_sha256");
    a.begun_at = text("begun_at");
    a.input = text("input");
    a.aids = text("aids");
    return a;
}

void read_items(soci::session& sql, Attempt& a) {
    const rowset<row> rows = (sql.prepare << "SELECT * FROM items WHERE attempt = :id", use(a.id));
    for (const row& r : rows) {
        a.items.push_back({r.get<std::string>("item"), r.get<std::string>("name"), number_in(r, "score"),
                           r.get<std::string>("capped_by")});
    }
}

void read_measures(soci::session& sql, Attempt& a) {
    const rowset<row> rows = (sql.prepare << "SELECT * FROM measures WHERE attempt = :id", use(a.id));
    for (const row& r : rows) {
        a.measures.push_back({r.get<std::string>("measure"), r.get<std::string>("name"), number_in(r, "value"),
                              r.get<std::string>("unit"), number_in(r, "score")});
    }
}

void read_events(soci::session& sql, Attempt& a) {
    const rowset<row> rows = (sql.prepare << "SELECT * FROM events WHERE attempt = :id ORDER BY number", use(a.id));
    for (const row& r : rows) {
        a.events.push_back({r.get<double>("time_s"), r.get<std::string>("step"), r.get<std::string>("event"),
                            r.get<std::string>("severity"), r.get<int>("recovered") != 0, number_in(r, "recovery_s")});
    }
}

void read_details(soci::session& sql, Attempt& a) {
    read_items(sql, a);
    read_measures(sql, a);
    read_events(sql, a);
}

}  // namespace

Result<Trainee> Store::trainee(const std::string& pseudonym) {
    return guarded(parts_->path, [&]() -> Result<Trainee> {
        Trainee found{pseudonym, "", ""};
        parts_->sql << "SELECT cohort, arm FROM trainees WHERE trainee = :trainee", into(found.cohort), into(found.arm),
            use(pseudonym);
        return found;
    });
}

Result<std::vector<Trainee>> Store::trainees() {
    return guarded(parts_->path, [&]() -> Result<std::vector<Trainee>> {
        std::vector<Trainee> all;
        const rowset<row> rows = (parts_->sql.prepare << "SELECT trainee, cohort, arm FROM trainees ORDER BY trainee");
        for (const row& r : rows) {
            all.push_back({r.get<std::string>(0), r.get<std::string>(1), r.get<std::string>(2)});
        }
        return all;
    });
}

Result<std::vector<Attempt>> Store::attempts(const Wanted& wanted) {
    return guarded(parts_->path, [&]() -> Result<std::vector<Attempt>> {
        std::vector<Attempt> all;
        const int finished = wanted.finished ? 1 : 0;
        const rowset<row> rows =
            (parts_->sql.prepare << "SELECT * FROM attempts WHERE (:t = '' OR trainee = :trainee) AND (:e = '' OR "
                                    "exercise = :exercise) AND (:c = '' OR cohort = :cohort) AND finished >= :finished "
                                    "ORDER BY begun, rowid",
             use(wanted.trainee), use(wanted.trainee), use(wanted.exercise), use(wanted.exercise), use(wanted.cohort),
             use(wanted.cohort), use(finished));
        for (const row& r : rows) {
            all.push_back(attempt_in(r));
        }
        for (Attempt& attempt : all) {
            if (wanted.details) {
                read_details(parts_->sql, attempt);
            }
        }
        return all;
    });
}

Result<Attempt> Store::attempt(const std::string& id) {
    return guarded(parts_->path, [&]() -> Result<Attempt> {
        std::vector<Attempt> found;
        const rowset<row> rows =
            (parts_->sql.prepare << "SELECT * FROM attempts WHERE substr(attempt, 1, length(:a)) = :b", use(id),
             use(id));
        for (const row& r : rows) {
            found.push_back(attempt_in(r));
        }
        if (id.empty() || found.size() != 1) {
            return Error{found.size() > 1 ? "more than one attempt begins with " + id : "there is no attempt " + id,
                         parts_->path, "an id, or its beginning, as rhexis records list shows it"};
        }
        read_details(parts_->sql, found.front());
        return found.front();
    });
}

Result<std::vector<Rating>> Store::ratings() {
    return guarded(parts_->path, [&]() -> Result<std::vector<Rating>> {
        std::vector<Rating> all;
        const rowset<row> rows = (parts_->sql.prepare << "SELECT * FROM ratings ORDER BY attempt, rater");
        for (const row& r : rows) {
            all.push_back({r.get<std::string>("attempt"),
                           r.get<std::string>("rater"),
                           r.get<std::string>("rated"),
                           r.get<std::string>("comment"),
                           {}});
        }
        for (Rating& rating : all) {
            const rowset<row> items =
                (parts_->sql.prepare << "SELECT * FROM rated_items WHERE attempt = :attempt AND rater = :rater",
                 use(rating.attempt), use(rating.rater));
            for (const row& r : items) {
                const bool scored = r.get_indicator("score") != soci::i_null;
                rating.items.push_back({r.get<std::string>("item"),
                                        scored ? std::optional<int>(r.get<int>("score")) : std::nullopt,
                                        r.get<std::string>("comment")});
            }
        }
        return all;
    });
}

}  // namespace rhexis::records
