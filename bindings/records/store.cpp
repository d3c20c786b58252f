// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/store.hpp"

#include <cstdlib>

#include "records/store_parts.hpp"

namespace rhexis::records {
namespace {

using soci::indicator;
using soci::into;
using soci::use;

indicator of(const std::optional<double>& value) { return value ? soci::i_ok : soci::i_null; }

void write_trainee(soci::session& sql, const Trainee& trainee) {
    sql << "INSERT INTO trainees VALUES (:trainee, :cohort, :arm) ON CONFLICT (trainee) DO UPDATE SET "
           "cohort = CASE excluded.cohort WHEN '' THEN cohort ELSE excluded.cohort END, "
           "arm = CASE excluded.arm WHEN '' THEN arm ELSE excluded.arm END",
        use(trainee.pseudonym), use(trainee.cohort), use(trainee.arm);
}

/// The row with what is known when an attempt begins.
void write_begin(soci::session& sql, const Attempt& a) {
    write_trainee(sql, a.trainee);
    const std::string seed = std::to_string(a.seed);
    sql << "INSERT INTO attempts (attempt, trainee, cohort, arm, exercise, title, version, sha256, surgeon, seed, "
           "begun, process, folder) VALUES (:id, :trainee, :cohort, :arm, :exercise, :title, :version, :sha256, "
           ":surgeon, :seed, :begun, :process, :folder) ON CONFLICT (attempt) DO UPDATE SET process = "
           "excluded.process, folder = excluded.folder",
        use(a.id), use(a.trainee.pseudonym), use(a.trainee.cohort), use(a.trainee.arm), use(a.exercise), use(a.title),
        use(a.version), use(a.sha256), use(a.surgeon), use(seed), use(a.begun), use(a.process), use(a.folder);
}

void write_result(soci::session& sql, const Attempt& a) {
    const double total = a.total.value_or(0.0);
    const double max = a.max.value_or(0.0);
    const double scaled = a.scaled.value_or(0.0);
    indicator has_total = of(a.total);
    indicator has_max = of(a.max);
    indicator has_scaled = of(a.scaled);
    const int completed = a.completed ? 1 : 0;
    sql << "UPDATE attempts SET finished = 1, ended = :ended, completed = :completed, duration_s = :duration, "
           "patient = :patient, settings = :settings, level = :level, mode = :mode, language = :language, "
           "rubric = :rubric, total = :total, max = :max, scaled = :scaled, error = :error, "
           "recording_sha256 = :recording, begun_at = :begun_at, input = :input, aids = :aids WHERE attempt = :id",
        use(a.ended), use(completed), use(a.duration_s), use(a.patient), use(a.settings), use(a.level), use(a.mode),
        use(a.language), use(a.rubric), use(total, has_total), use(max, has_max), use(scaled, has_scaled), use(a.error),
        use(a.recording_sha256), use(a.begun_at), use(a.input), use(a.aids), use(a.id);
}

void write_items(soci::session& sql, const Attempt& a) {
    sql << "DELETE FROM items WHERE attempt = :id", use(a.id);
    for (const ItemScore& item : a.items) {
        const double score = item.score.value_or(0.0);
        indicator has_score = of(item.score);
        sql << "INSERT INTO items VALUES (:attempt, :item, :name, :score, :capped)", use(a.id), use(item.id),
            use(item.name), use(score, has_score), use(item.capped_by);
    }
}

void write_measures(soci::session& sql, const Attempt& a) {
    sql << "DELETE FROM measures WHERE attempt = :id", use(a.id);
    for (const MeasureValue& measure : a.measures) {
        const double value = measure.value.value_or(0.0);
        const double score = measure.score.value_or(0.0);
        indicator has_value = of(measure.value);
        indicator has_score = of(measure.score);
        sql << "INSERT OR REPLACE INTO measures VALUES (:attempt, :measure, :name, :value, :unit, :score)", use(a.id),
            use(measure.id), use(measure.name), use(value, has_value), use(measure.unit), use(score, has_score);
    }
}

void write_events(soci::session& sql, const Attempt& a) {
    sql << "DELETE FROM events WHERE attempt = :id", use(a.id);
    int number = 0;
    for (const EventRow& event : a.events) {
        ++number;
        const double recovery_s = event.recovery_s.value_or(0.0);
        indicator has_recovery = of(event.recovery_s);
        const int recovered = event.recovered ? 1 : 0;
        sql << "INSERT INTO events VALUES (:attempt, :number, :time, :step, :event, :severity, :recovered, :recovery)",
            use(a.id), use(number), use(event.time_s), use(event.step), use(event.id), use(event.severity),
            use(recovered), use(recovery_s, has_recovery);
    }
}

void write_rating(soci::session& sql, const Rating& rating) {
    sql << "INSERT INTO ratings VALUES (:attempt, :rater, :rated, :comment)", use(rating.attempt), use(rating.rater),
        use(rating.rated), use(rating.comment);
    for (const RatedItem& item : rating.items) {
        const int score = item.score.value_or(0);
        indicator has_score = item.score ? soci::i_ok : soci::i_null;
        sql << "INSERT INTO rated_items VALUES (:attempt, :rater, :item, :score, :comment)", use(rating.attempt),
            use(rating.rater), use(item.id), use(score, has_score), use(item.comment);
    }
}

}  // namespace

Store::Store(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

namespace {

Result<std::unique_ptr<Store::Parts>> open_parts(const std::string& path, Opening how) {
    std::unique_ptr<Store::Parts> parts = std::make_unique<Store::Parts>();
    parts->path = path;
    const Status opened = guarded(path, [&] { return open_database(parts->sql, path, how); });
    if (!opened) {
        return opened.error();
    }
    return parts;
}

}  // namespace

Result<Store> Store::open(const std::string& path) {
    Result<std::unique_ptr<Parts>> parts = open_parts(path, Opening::create);
    return parts ? Result<Store>(Store(std::move(parts).value())) : parts.error();
}

Result<Store> Store::open_existing(const std::string& path) {
    Result<std::unique_ptr<Parts>> parts = open_parts(path, Opening::existing);
    return parts ? Result<Store>(Store(std::move(parts).value())) : parts.error();
}

const std::string& Store::path() const { return parts_->path; }

Status Store::begin(const Attempt& attempt) {
    return guarded(parts_->path, [&] {
        Writing writing(parts_->sql);
        write_begin(parts_->sql, attempt);
        writing.commit();
        return success();
    });
}

Status Store::finish(const Attempt& attempt) {
    return guarded(parts_->path, [&] {
        soci::session& sql = parts_->sql;
        Writing writing(sql);
        write_begin(sql, attempt);
        write_result(sql, attempt);
        write_items(sql, attempt);
        write_measures(sql, attempt);
        write_events(sql, attempt);
        writing.commit();
        return success();
    });
}

Status Store::drop(const std::string& id) {
    return guarded(parts_->path, [&] {
        Writing writing(parts_->sql);
        parts_->sql << "DELETE FROM attempts WHERE attempt = :id AND finished = 0", use(id);
        writing.commit();
        return success();
    });
}

Result<std::vector<std::string>> Store::remove(const std::string& pseudonym) {
    return guarded(parts_->path, [&]() -> Result<std::vector<std::string>> {
        soci::session& sql = parts_->sql;
        Writing writing(sql);
        std::vector<std::string> folders;
        const soci::rowset<std::string> rows =
            (sql.prepare << "SELECT folder FROM attempts WHERE trainee = :trainee ORDER BY begun", use(pseudonym));
        for (const std::string& folder : rows) {
            folders.push_back(folder);
        }
        sql << "DELETE FROM trainees WHERE trainee = :trainee", use(pseudonym);  // and all that refers to it
        sql << "DELETE FROM ratings WHERE rater = :rater", use(pseudonym);
        writing.commit();
        sql << "VACUUM";  // pages that were freed before the store erased what it deletes
        return folders;
    });
}

Status Store::rate(const std::vector<Rating>& ratings, bool replace) {
    return guarded(parts_->path, [&]() -> Status {
        Writing writing(parts_->sql);
        for (const Rating& rating : ratings) {
            if (replace) {
                parts_->sql << "DELETE FROM ratings WHERE attempt = :attempt AND rater = :rater", use(rating.attempt),
                    use(rating.rater);
            }
            int before = 0;
            parts_->sql << "SELECT count(*) FROM ratings WHERE attempt = :attempt AND rater = :rater", into(before),
                use(rating.attempt), use(rating.rater);
            if (before > 0) {
                return Error{rating.rater + " has rated attempt " + rating.attempt.substr(0, 8) + " already",
                             parts_->path, "--replace"};
            }
            write_rating(parts_->sql, rating);
        }
        writing.commit();
        return success();
    });
}

std::string default_store() {
    const auto environment = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value != nullptr ? value : "");
    };
    if (std::string named = environment("RHEXIS_RECORDS"); !named.empty()) {
        return named;
    }
    if (const std::string data = environment("XDG_DATA_HOME"); !data.empty()) {
        return data + "/rhexis/records.db";
    }
    const std::string home = environment("HOME");
    return home.empty() ? "" : home + "/.local/share/rhexis/records.db";
}

}  // namespace rhexis::records
