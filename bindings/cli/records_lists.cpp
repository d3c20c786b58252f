// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records list, show, trainees.
#include <cstdio>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/counted.hpp"
#include "cli/records_command.hpp"
#include "cli/records_json.hpp"

namespace rhexis::cli {
namespace {

using records::Attempt;
using records::AttemptState;

std::string score_text(const Attempt& attempt) {
    if (attempt.state != AttemptState::finished) {
        return state_name(attempt.state);
    }
    if (!attempt.scaled || !attempt.total) {
        return "no score";
    }
    char text[48];
    std::snprintf(text, sizeof text, "%g of %g (%.2f)", *attempt.total, attempt.max.value_or(0.0), *attempt.scaled);
    return text;
}

/// Where a run that broke off lies; else whether all was done, and from which moment on.
std::string what_became(const Attempt& a) {
    if (a.state != AttemptState::finished) {
        return a.state == AttemptState::interrupted ? a.folder : "";
    }
    return std::string(a.completed ? "completed" : "not completed") +
           (a.begun_at.empty() ? "" : ", begun at " + a.begun_at) + (a.aids.empty() ? "" : ", with aids: " + a.aids);
}

void print_line(const Attempt& a) {
    std::printf("%-8s  %-16s  %-12s  %-20s  %-20s  %s\n", a.id.substr(0, 8).c_str(), a.begun.substr(0, 16).c_str(),
                a.trainee.pseudonym.c_str(), a.exercise.c_str(), score_text(a).c_str(), what_became(a).c_str());
}

int list(const RecordsOptions& given) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return complain(store.error());
    }
    const Result<std::vector<Attempt>> attempts = store.value().attempts(wanted_by(given));
    if (!attempts) {
        return complain(attempts.error());
    }
    if (const Status known = check_wanted(store.value(), given, attempts.value()); !known) {
        return complain(known.error());
    }
    if (given.json) {
        nlohmann::json all = nlohmann::json::array();
        for (const Attempt& attempt : attempts.value()) {
            all.push_back(attempt_json(attempt));
        }
        std::cout << all.dump(2) << '\n';
        return done;
    }
    std::printf("%-8s  %-16s  %-12s  %-20s  %s\n", "attempt", "begun (UTC)", "trainee", "exercise", "score");
    for (const Attempt& attempt : attempts.value()) {
        print_line(attempt);
    }
    std::printf("%s; scores are not clinically validated\n", counted(attempts.value().size(), "attempt").c_str());
    return done;
}

void print_attempt(const Attempt& a) {
    std::printf("%s: %s by %s%s%s%s%s\n", a.id.c_str(), a.exercise.c_str(), a.trainee.pseudonym.c_str(),
                a.trainee.cohort.empty() ? "" : ", cohort ", a.trainee.cohort.c_str(),
                a.trainee.arm.empty() ? "" : ", arm ", a.trainee.arm.c_str());
    std::printf("  begun      %s%s%s\n", a.begun.c_str(), a.ended.empty() ? "" : ", ended ", a.ended.c_str());
    std::printf("  exercise   version %g, %s\n", a.version, a.sha256.c_str());
    std::printf("  operated   by %s, seed %llu\n", a.surgeon.c_str(), static_cast<unsigned long long>(a.seed));
    std::printf("  folder     %s\n", a.folder.c_str());
    std::printf("  score      %s\n", score_text(a).c_str());
    if (a.state != AttemptState::finished) {
        std::printf("  recording  %s/recording.rhx.part, as far as it came\n", a.folder.c_str());
        return;
    }
    std::printf("  went       %s, after %.1f s%s%s\n", what_became(a).c_str(), a.duration_s,
                a.error.empty() ? "" : ": ", a.error.c_str());
    std::printf("  with       mode %s%s%s, patient %s, set %s\n", a.mode.c_str(), a.level.empty() ? "" : ", level ",
                a.level.c_str(), a.patient.c_str(), a.settings.c_str());
    for (const records::ItemScore& item : a.items) {
        if (item.score) {
            std::printf("  %-4s %4.1f  %s%s%s\n", item.id.c_str(), *item.score, item.name.c_str(),
                        item.capped_by.empty() ? "" : "; capped by ", item.capped_by.c_str());
        }
    }
    for (const records::EventRow& event : a.events) {
        std::printf("  error      after %.1f s: %s (%s), %s\n", event.time_s, event.id.c_str(), event.severity.c_str(),
                    event.recovered ? "put right" : "not put right");
    }
}

int show(const RecordsOptions& given) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return complain(store.error());
    }
    const Result<Attempt> attempt = store.value().attempt(given.attempt);
    if (!attempt) {
        return complain(attempt.error());
    }
    if (given.json) {
        std::cout << attempt_json(attempt.value()).dump(2) << '\n';
    } else {
        print_attempt(attempt.value());
    }
    return done;
}

int trainees(const RecordsOptions& given) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return complain(store.error());
    }
    const Result<std::vector<records::Trainee>> all = store.value().trainees();
    const Result<std::vector<Attempt>> attempts = store.value().attempts({});
    if (!all || !attempts) {
        return complain(all ? attempts.error() : all.error());
    }
    std::map<std::string, int> count;
    for (const Attempt& attempt : attempts.value()) {
        count[attempt.trainee.pseudonym] += 1;
    }
    std::printf("%-16s  %-16s  %-16s  %s\n", "trainee", "cohort", "arm", "attempts");
    for (const records::Trainee& one : all.value()) {
        std::printf("%-16s  %-16s  %-16s  %d\n", one.pseudonym.c_str(), one.cohort.c_str(), one.arm.c_str(),
                    count[one.pseudonym]);
    }
    return done;
}

}  // namespace

void add_records_lists(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context) {
    CLI::App* command = records.add_subcommand("list", "Attempts, oldest first");
    command->add_option("--trainee", given->trainee, "Of this one only");
    command->add_option("--exercise", given->exercise, "At this one only");
    command->add_option("--cohort", given->cohort, "Of this cohort only");
    command->add_flag("--json", given->json, "Print them as JSON");
    command->callback([given, &context] { context.status = list(*given); });

    command = records.add_subcommand("show", "One attempt: scores, errors, where its run lies");
    command->add_option("attempt", given->attempt, "Its id, or the beginning of it")->required();
    command->add_flag("--json", given->json, "Print all that is stored of it as JSON");
    command->callback([given, &context] { context.status = show(*given); });

    command = records.add_subcommand("trainees", "Pseudonyms, cohorts and arms");
    command->callback([given, &context] { context.status = trainees(*given); });
}

}  // namespace rhexis::cli
