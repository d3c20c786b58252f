// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records: what is stored of trainees.
#include "cli/records_command.hpp"

#include <set>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "base/output_file.hpp"
#include "cli/gates_file.hpp"
#include "cli/run_folder.hpp"
#include "lua/report_script.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using records::Attempt;
using records::AttemptState;
using records::Store;

constexpr const char* records_help =
    "Attempts are stored by rhexis run EXERCISE --trainee PSEUDONYM, and nothing is without it.\n"
    "\n"
    "  rhexis run groove --surgeon b --trainee P07 --cohort 2026 --arm simulator\n"
    "  rhexis records list                           all attempts, oldest first\n"
    "  rhexis records show 3fa8                      one of them, by the beginning of its id\n"
    "  rhexis records curve P07 --exercise groove    how the scores of P07 came along\n"
    "  rhexis records gates P07                      which exercises P07 has passed often enough\n"
    "  rhexis records next P07                       which lesson of the course comes next\n"
    "  rhexis records course --html course.html      everybody, trainee by exercise\n"
    "  rhexis records export --out csv/              attempts.csv, items.csv, measures.csv, events.csv, ...\n"
    "  rhexis records delete P07 --yes --runs        P07, all that is stored, and the folders of the runs\n"
    "  rhexis records add runs/groove-P07-20260301-093000    what could not be stored when it ended\n"
    "  rhexis records agreement --html agreement.html        simulator against raters, see rhexis rate --help\n"
    "\n"
    "The store is one SQLite file: --records FILE, or RHEXIS_RECORDS, or rhexis/records.db in the user's data folder.\n"
    "docs/records.md describes its tables.";

/// Quietly: a store that cannot be written can still be read.
void settle(Store& store) {
    const Result<std::vector<Attempt>> attempts = store.attempts({});
    if (!attempts) {
        return;
    }
    for (Attempt attempt : attempts.value()) {
        if (attempt.state != AttemptState::interrupted) {
            continue;
        }
        const Result<Attempt> note = read_note(attempt.folder);
        if (note && note.value().id == attempt.id && complete_from_folder(attempt)) {
            static_cast<void>(store.finish(attempt));
        }
    }
}

}  // namespace

Result<Store> open_records(const RecordsOptions& given) {
    Result<Store> store = Store::open_existing(given.store.empty() ? records::default_store() : given.store);
    if (store) {
        settle(store.value());
    }
    return store;
}

records::Wanted wanted_by(const RecordsOptions& given) {
    records::Wanted wanted;
    wanted.trainee = given.trainee;
    wanted.exercise = given.exercise;
    wanted.cohort = given.cohort;
    return wanted;
}

Result<std::vector<Attempt>> finished_attempts(Store& store, const RecordsOptions& given) {
    records::Wanted wanted = wanted_by(given);
    wanted.finished = true;
    wanted.details = true;
    return store.attempts(wanted);
}

Status check_wanted(Store& store, const RecordsOptions& given, const std::vector<Attempt>& found) {
    if (!found.empty()) {
        return success();
    }
    const Result<std::vector<Attempt>> all = store.attempts({});
    if (!all) {
        return all.error();
    }
    std::set<std::string> trainees;
    std::set<std::string> exercises;
    std::set<std::string> cohorts;
    for (const Attempt& attempt : all.value()) {
        trainees.insert(attempt.trainee.pseudonym);
        exercises.insert(attempt.exercise);
        cohorts.insert(attempt.trainee.cohort);
    }
    const auto check = [&store](const std::string& what, const std::string& name, const std::set<std::string>& known) {
        const std::vector<std::string> names(known.begin(), known.end());
        return name.empty() || known.contains(name) ? success()
                                                    : Status(Error{"no attempt is stored of the " + what + " " + name,
                                                                   store.path(), suggestion(name, names)});
    };
    Status status = check("trainee", given.trainee, trainees);
    status = status ? check("exercise", given.exercise, exercises) : status;
    return status ? check("cohort", given.cohort, cohorts) : status;
}

void add_page_language(CLI::App& command, const std::shared_ptr<RecordsOptions>& given, CLI::Option* html) {
    command.add_option("--language", given->language, "Of the page of --html: en, fr, ... [as LANG says]")->needs(html);
}

Status check_page_language(const RecordsOptions& given, const Context& context) {
    const Result<std::string> language = language_of_page(given.language, context.root);
    return language ? success() : Status(language.error());
}

int write_records_page(const RecordsOptions& given, const std::string& module, nlohmann::json data,
                       const Context& context) {
    const Result<std::string> language = language_of_page(given.language, context.root);
    if (!language) {
        return complain(language.error());
    }
    data["language"] = language.value().empty() ? "en" : language.value();
    const Result<std::string> html = page_html(context.root, module, data);
    const Status written = html ? write_file(given.html, html.value()) : Status(html.error());
    return written ? done : complain(written.error());
}

Result<records::Gates> gates_of(const RecordsOptions& given, const Context& context) {
    Result<records::Gates> gates = read_gates(given.gates, context.root);
    if (!gates || given.pass < 0.0) {
        return gates;
    }
    if (const Status status = check_range("--pass", given.pass, 0.0, 1.0); !status) {
        return status.error();
    }
    gates.value().usual.pass = given.pass;
    for (auto& [exercise, gate] : gates.value().exercises) {
        gate.pass = given.pass;
    }
    return gates;
}

void add_records(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("records", "Attempts of trainees: lists, learning curves, gates, export");
    command->footer(records_help);
    command->require_subcommand(1);
    command->fallthrough();
    auto given = std::make_shared<RecordsOptions>();
    command->add_option("--records", given->store, "File [RHEXIS_RECORDS, or rhexis/records.db in the data folder]");
    add_records_lists(*command, given, context);
    add_records_progress(*command, given, context);
    add_records_course(*command, given, context);
    add_records_agreement(*command, given, context);
    add_records_keeping(*command, given, context);
}

}  // namespace rhexis::cli
