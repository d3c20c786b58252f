// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kept_attempt.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/course_file.hpp"
#include "cli/gates_file.hpp"
#include "cli/run_folder.hpp"
#include "records/history.hpp"
#include "records/identity.hpp"
#include "records/process_mark.hpp"
#include "records/pseudonym.hpp"
#include "records/store.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using records::Attempt;
using records::Store;

bool is_locked(const Error& error) { return error.what.starts_with("locked"); }

Error later(const Error& error, const std::string& folder) {
    return {"the attempt is not stored: " + error.text(), "",
            "its report and recording are in " + folder + "; rhexis records add " + folder + " stores it"};
}

Attempt attempt_that_begins(const KeepOptions& options, const json& identity, const std::string& folder, bool resume) {
    Attempt attempt;
    const Result<Attempt> before = read_note(folder);
    const bool goes_on = resume && before && before.value().trainee.pseudonym == options.trainee;
    attempt.id = goes_on ? before.value().id : records::new_id();
    attempt.begun = goes_on ? before.value().begun : records::now_utc();
    attempt.trainee = {options.trainee, options.cohort, options.arm};
    attempt.exercise = identity.value("id", "");
    attempt.input = options.input;
    attempt.title = identity.value("title", "");
    const json version = identity.value("version", json());
    attempt.version = version.is_number() ? version.get<double>() : 0.0;
    attempt.sha256 = identity.value("sha256", "");
    attempt.process = records::process_mark();
    attempt.folder = fs::absolute(folder).lexically_normal().string();
    return attempt;
}

/// Whether the trainee has come to this exercise in the course: one that is closed is told on stderr, or refused. What
/// is no lesson of the course is nobody's concern here.
Status check_lesson(const std::string& path, const records::Gates& gates, const KeepOptions& options,
                    const std::string& exercise) {
    const std::string named = course_named(options.course);
    if (named.empty()) {
        return success();
    }
    const Result<records::LessonPlan> plan = read_course(named, options.root);
    if (!plan) {
        return plan.error();
    }
    Result<Store> store = Store::open(path);
    if (!store) {  // one that is locked tells nothing now, and does not stand in the way
        return is_locked(store.error()) ? success() : Status(store.error());
    }
    records::Wanted wanted;
    wanted.trainee = options.trainee;
    wanted.finished = true;
    wanted.details = true;
    const Result<std::vector<Attempt>> attempts = store.value().attempts(wanted);
    if (!attempts) {
        return is_locked(attempts.error()) ? success() : Status(attempts.error());
    }
    for (const records::LessonState& state : records::states_of(plan.value(), gates, attempts.value())) {
        if (state.lesson.exercise == exercise && !state.open()) {
            const Error closed{exercise + " is closed to " + options.trainee + " in the course " + plan.value().name +
                                   " until " + state.waits_for.front() + " is passed",
                               "", "rhexis records next " + options.trainee + " tells what is open"};
            if (plan.value().refuses) {
                return closed;
            }
            std::fprintf(stderr, "rhexis: notice: %s\n", closed.text().c_str());
        }
    }
    return success();
}

/// Besides, fills in the trainee's cohort and arm where they are known, and what to compare with.
Status begin_in_store(const std::string& path, const records::Gates& gates, Attempt& attempt, json& comparison) {
    Result<Store> store = Store::open(path);
    if (!store) {
        return store.error();
    }
    const Result<records::Trainee> known = store.value().trainee(attempt.trainee.pseudonym);
    if (!known) {
        return known.error();
    }
    if (attempt.trainee.cohort.empty()) {
        attempt.trainee.cohort = known.value().cohort;
    }
    if (attempt.trainee.arm.empty()) {
        attempt.trainee.arm = known.value().arm;
    }
    Result<json> found = records::comparison_for(store.value(), attempt, gates);
    if (!found) {
        return found.error();
    }
    comparison = std::move(found).value();
    return store.value().begin(attempt);
}

}  // namespace

struct KeptAttempt::Parts {
    std::string store;
    Attempt attempt;
    json comparison = json::object();
};

Status check_keep_options(const KeepOptions& options) {
    if (options.trainee.empty()) {
        for (const auto& [option, value] :
             {std::pair("--cohort", options.cohort), std::pair("--arm", options.arm),
              std::pair("--course", options.course), std::pair("--records", options.store)}) {
            if (!value.empty()) {
                return Error{std::string(option) + " is for attempts of a trainee, and none is named", "",
                             "--trainee PSEUDONYM"};
            }
        }
        return success();
    }
    for (const auto& [option, name] : {std::pair("--trainee", options.trainee), std::pair("--cohort", options.cohort),
                                       std::pair("--arm", options.arm)}) {
        const bool must = option == std::string("--trainee");
        if (Status status = must || !name.empty() ? records::check_pseudonym(name, option) : success(); !status) {
            return status;
        }
    }
    return success();
}

std::string folder_name_of(const std::string& exercise, const std::string& trainee) {
    std::string moment = records::now_utc();
    std::erase_if(moment, [](char c) { return c == '-' || c == ':' || c == 'Z'; });
    std::replace(moment.begin(), moment.end(), 'T', '-');
    return exercise + "-" + trainee + "-" + moment;
}

KeptAttempt::KeptAttempt(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
KeptAttempt::~KeptAttempt() = default;
KeptAttempt::KeptAttempt(KeptAttempt&&) noexcept = default;

Result<KeptAttempt> KeptAttempt::begin(const KeepOptions& options, const json& identity, const std::string& surgeon,
                                       std::uint64_t seed, const std::string& folder, bool resume) {
    if (options.trainee.empty()) {
        return KeptAttempt(nullptr);
    }
    std::unique_ptr<Parts> parts = std::make_unique<Parts>();
    parts->store = options.store.empty() ? records::default_store() : options.store;
    Attempt& attempt = parts->attempt;
    attempt = attempt_that_begins(options, identity, folder, resume);
    attempt.surgeon = surgeon;
    attempt.seed = seed;
    const Result<records::Gates> gates = read_gates("", options.root);
    if (!gates) {
        return gates.error();
    }
    Status status = check_lesson(parts->store, gates.value(), options, attempt.exercise);
    if (!status) {
        return status.error();
    }
    status = begin_in_store(parts->store, gates.value(), attempt, parts->comparison);
    parts->comparison["attempt"] = attempt.id;  // a report that an earlier run left in the folder has another
    if (!status && !is_locked(status.error())) {
        return status.error();
    }
    status = prepare_folder(folder);
    if (status) {
        status = write_note(folder, attempt, false);
    }
    if (!status) {
        return status.error();
    }
    return KeptAttempt(std::move(parts));
}

const json& KeptAttempt::comparison() const {
    static const json none = json::object();
    return parts_ ? parts_->comparison : none;
}

Status KeptAttempt::finish(const json& report) {
    if (!parts_) {
        return success();
    }
    Attempt& attempt = parts_->attempt;
    Status status = complete(attempt, report);
    if (status) {
        Result<Store> store = Store::open(parts_->store);
        status = store ? store.value().finish(attempt) : Status(store.error());
    }
    return status ? status : Status(later(status.error(), attempt.folder));
}

void KeptAttempt::give_up() {
    if (!parts_) {
        return;
    }
    std::error_code ignored;
    const std::string recording = recording_path(parts_->attempt.folder);
    if (fs::exists(recording, ignored) || fs::exists(parts_->attempt.folder + "/parts", ignored)) {
        return;  // shown as interrupted once this process is gone
    }
    fs::remove(parts_->attempt.folder + "/" + note_file, ignored);
    Result<Store> store = Store::open(parts_->store);
    if (store) {
        static_cast<void>(store.value().drop(parts_->attempt.id));
    }
}

}  // namespace rhexis::cli
