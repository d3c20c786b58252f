// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/csv.hpp"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <optional>

namespace rhexis::records {
namespace {

/// One table, line by line.
class Table {
public:
    Table(const CsvStyle& style, std::initializer_list<std::string> header) : style_(style) {
        text_ = style.mark ? "\xEF\xBB\xBF" : "";
        line(header);
    }
    void line(std::initializer_list<std::string> cells) {
        for (const std::string& one : cells) {
            text_ += one + style_.separator;
        }
        text_.back() = '\n';
    }
    /// Quoted where it must be. A text that a spreadsheet would take for a formula gets an apostrophe.
    [[nodiscard]] std::string cell(const std::string& text) const {
        const bool formula = !text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos;
        std::string content = (formula ? "'" : "") + text;
        if (content.find_first_of(std::string("\"\r\n") + style_.separator) == std::string::npos) {
            return content;
        }
        std::string quoted = "\"";
        for (const char c : content) {
            quoted.append(c == '"' ? 2 : 1, c);
        }
        return quoted + "\"";
    }
    [[nodiscard]] std::string cell(double value) const {
        char text[32];
        std::snprintf(text, sizeof text, "%.10g", value);
        std::string number = text;
        std::replace(number.begin(), number.end(), '.', style_.decimal);
        return number;
    }
    [[nodiscard]] std::string cell(const std::optional<double>& value) const { return value ? cell(*value) : ""; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    CsvStyle style_;
    std::string text_;
};

const char* name_of(AttemptState state) {
    return state == AttemptState::finished ? "finished" : state == AttemptState::running ? "running" : "interrupted";
}

std::string attempts_csv(const std::vector<Attempt>& attempts, const CsvStyle& style) {
    Table table(style,
                {"attempt", "trainee",   "cohort",    "arm",    "exercise",        "version",    "sha256",   "surgeon",
                 "seed",    "begun_utc", "ended_utc", "state",  "completed",       "duration_s", "rubric",   "total",
                 "max",     "scaled",    "level",     "mode",   "language",        "patient",    "settings", "begun_at",
                 "input",   "aids",      "error",     "folder", "recording_sha256"});
    for (const Attempt& a : attempts) {
        table.line({table.cell(a.id),
                    table.cell(a.trainee.pseudonym),
                    table.cell(a.trainee.cohort),
                    table.cell(a.trainee.arm),
                    table.cell(a.exercise),
                    table.cell(a.version),
                    table.cell(a.sha256),
                    table.cell(a.surgeon),
                    std::to_string(a.seed),
                    table.cell(a.begun),
                    table.cell(a.ended),
                    name_of(a.state),
                    a.completed ? "1" : "0",
                    table.cell(a.duration_s),
                    table.cell(a.rubric),
                    table.cell(a.total),
                    table.cell(a.max),
                    table.cell(a.scaled),
                    table.cell(a.level),
                    table.cell(a.mode),
                    table.cell(a.language),
                    table.cell(a.patient),
                    table.cell(a.settings),
                    table.cell(a.begun_at),
                    table.cell(a.input),
                    table.cell(a.aids),
                    table.cell(a.error),
                    table.cell(a.folder),
                    table.cell(a.recording_sha256)});
    }
    return table.text();
}

std::string items_csv(const std::vector<Attempt>& attempts, const CsvStyle& style) {
    Table table(style, {"attempt", "item", "name", "score", "capped_by"});
    for (const Attempt& a : attempts) {
        for (const ItemScore& item : a.items) {
            table.line({table.cell(a.id), table.cell(item.id), table.cell(item.name), table.cell(item.score),
                        table.cell(item.capped_by)});
        }
    }
    return table.text();
}

std::string measures_csv(const std::vector<Attempt>& attempts, const CsvStyle& style) {
    Table table(style, {"attempt", "measure", "name", "value", "unit", "score"});
    for (const Attempt& a : attempts) {
        for (const MeasureValue& m : a.measures) {
            table.line({table.cell(a.id), table.cell(m.id), table.cell(m.name), table.cell(m.value), table.cell(m.unit),
                        table.cell(m.score)});
        }
    }
    return table.text();
}

std::string events_csv(const std::vector<Attempt>& attempts, const CsvStyle& style) {
    Table table(style, {"attempt", "t_s", "step", "event", "severity", "recovered", "t_recover_s"});
    for (const Attempt& a : attempts) {
        for (const EventRow& e : a.events) {
            table.line({table.cell(a.id), table.cell(e.time_s), table.cell(e.step), table.cell(e.id),
                        table.cell(e.severity), e.recovered ? "1" : "0", table.cell(e.recovery_s)});
        }
    }
    return table.text();
}

std::string ratings_csv(const std::vector<Rating>& ratings, const CsvStyle& style) {
    Table table(style, {"attempt", "rater", "rated_utc", "item", "score", "comment"});
    for (const Rating& rating : ratings) {
        for (const RatedItem& item : rating.items) {
            table.line({table.cell(rating.attempt), table.cell(rating.rater), table.cell(rating.rated),
                        table.cell(item.id), item.score ? std::to_string(*item.score) : "", table.cell(item.comment)});
        }
    }
    return table.text();
}

}  // namespace

std::map<std::string, std::string> csv_of(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings,
                                          const CsvStyle& style) {
    return {{"attempts.csv", attempts_csv(attempts, style)},
            {"items.csv", items_csv(attempts, style)},
            {"measures.csv", measures_csv(attempts, style)},
            {"events.csv", events_csv(attempts, style)},
            {"ratings.csv", ratings_csv(ratings, style)}};
}

}  // namespace rhexis::records
