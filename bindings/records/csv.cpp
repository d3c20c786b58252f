// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/csv.hpp"

#include <cstdio>
#include <initializer_list>
#include <optional>

namespace rhexis::records {
namespace {

/// Quoted where it must be. A text that a spreadsheet would take for a formula gets an apostrophe.
std::string cell(const std::string& text) {
    const bool formula = !text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos;
    std::string content = (formula ? "'" : "") + text;
    if (content.find_first_of(",\"\r\n") == std::string::npos) {
        return content;
    }
    std::string quoted = "\"";
    for (const char c : content) {
        quoted.append(c == '"' ? 2 : 1, c);
    }
    return quoted + "\"";
}

std::string cell(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string cell(const std::optional<double>& value) { return value ? cell(*value) : ""; }

std::string line(std::initializer_list<std::string> cells) {
    std::string all;
    for (const std::string& one : cells) {
        all += one + ",";
    }
    all.back() = '\n';
    return all;
}

const char* name_of(AttemptState state) {
    return state == AttemptState::finished ? "finished" : state == AttemptState::running ? "running" : "interrupted";
}

std::string attempts_csv(const std::vector<Attempt>& attempts) {
    std::string all =
        "attempt,trainee,cohort,arm,exercise,version,sha256,surgeon,seed,begun_utc,ended_utc,state,completed,duration_"
        "s,"
        "rubric,total,max,scaled,level,mode,language,patient,settings,begun_at,error,folder,recording_sha256\n";
    for (const Attempt& a : attempts) {
        all += line({cell(a.id),
                     cell(a.trainee.pseudonym),
                     cell(a.trainee.cohort),
                     cell(a.trainee.arm),
                     cell(a.exercise),
                     cell(a.version),
                     cell(a.sha256),
                     cell(a.surgeon),
                     std::to_string(a.seed),
                     cell(a.begun),
                     cell(a.ended),
                     name_of(a.state),
                     a.completed ? "1" : "0",
                     cell(a.duration_s),
                     cell(a.rubric),
                     cell(a.total),
                     cell(a.max),
                     cell(a.scaled),
                     cell(a.level),
                     cell(a.mode),
                     cell(a.language),
                     cell(a.patient),
                     cell(a.settings),
                     cell(a.begun_at),
                     cell(a.error),
                     cell(a.folder),
                     cell(a.recording_sha256)});
    }
    return all;
}

std::string items_csv(const std::vector<Attempt>& attempts) {
    std::string all = "attempt,item,name,score,capped_by\n";
    for (const Attempt& a : attempts) {
        for (const ItemScore& item : a.items) {
            all += line({cell(a.id), cell(item.id), cell(item.name), cell(item.score), cell(item.capped_by)});
        }
    }
    return all;
}

std::string measures_csv(const std::vector<Attempt>& attempts) {
    std::string all = "attempt,measure,name,value,unit,score\n";
    for (const Attempt& a : attempts) {
        for (const MeasureValue& m : a.measures) {
            all += line({cell(a.id), cell(m.id), cell(m.name), cell(m.value), cell(m.unit), cell(m.score)});
        }
    }
    return all;
}

std::string events_csv(const std::vector<Attempt>& attempts) {
    std::string all = "attempt,t_s,step,event,severity,recovered,t_recover_s\n";
    for (const Attempt& a : attempts) {
        for (const EventRow& e : a.events) {
            all += line({cell(a.id), cell(e.time_s), cell(e.step), cell(e.id), cell(e.severity),
                         e.recovered ? "1" : "0", cell(e.recovery_s)});
        }
    }
    return all;
}

std::string ratings_csv(const std::vector<Rating>& ratings) {
    std::string all = "attempt,rater,rated_utc,item,score,comment\n";
    for (const Rating& rating : ratings) {
        for (const RatedItem& item : rating.items) {
            all += line({cell(rating.attempt), cell(rating.rater), cell(rating.rated), cell(item.id),
                         item.score ? std::to_string(*item.score) : "", cell(item.comment)});
        }
    }
    return all;
}

}  // namespace

std::map<std::string, std::string> csv_of(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings) {
    return {{"attempts.csv", attempts_csv(attempts)},
            {"items.csv", items_csv(attempts)},
            {"measures.csv", measures_csv(attempts)},
            {"events.csv", events_csv(attempts)},
            {"ratings.csv", ratings_csv(ratings)}};
}

}  // namespace rhexis::records
