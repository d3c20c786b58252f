// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis study: groups of virtual surgeons attempt exercises, and how far apart their scores are.
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/output_file.hpp"
#include "cli/command.hpp"
#include "cli/study_cohort.hpp"
#include "cli/study_gates.hpp"
#include "cli/study_result.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/operation_script.hpp"
#include "trial/attempt.hpp"
#include "trial/operation.hpp"
#include "trial/places.hpp"
#include "trial/progress.hpp"
#include "trial/rescore.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;

constexpr const char* study_help =
    "Virtual surgeons of each group attempt each exercise with each seed; studies/NAME.json says which.\n"
    "\n"
    "  rhexis study part_exercises              tables, and runs/study-part_exercises/\n"
    "  rhexis study part_exercises --resume     without the attempts that are there already\n"
    "  rhexis study my_study.json --jobs 2 --out DIR\n"
    "  rhexis study part_exercises --judge-again     attempts that are there, by the rules of today: judged_again.md\n"
    "  rhexis study full_operations             whole operations: hours\n"
    "  rhexis study cohort                      what the report compares attempts with: cohorts.json\n"
    "  rhexis study gates                       whether experts pass the gates and beginners do not: "
    "gates_accepted.json\n"
    "  rhexis study gates --seeds 9305-9306 --with rubrics/gates_accepted.json\n"
    "                                           some of its seeds, added to what earlier ones gave\n"
    "  rhexis study gates --check               whether what was accepted is still true of exercises and gates\n"
    "\n"
    "DIR receives study.json, study.md and a folder per attempt with report and recording. The numbers that the "
    "groups\n"
    "differ by are in scripts/surgeons/groups.lua; study.json names its hash.";

struct StudyOptions {
    std::string study;
    std::string out;
    int jobs = 0;
    bool resume = false;
    bool judge_again = false;
    bool json = false;
    bool check = false;
    std::string seeds;
    std::string with;
};

struct StudyJob {
    const StudyExercise* exercise = nullptr;
    std::string folder;
    json fingerprint;
    Start start{};
    std::optional<Operation> operation{};  ///< in place of an exercise
    StudyRun run;
    std::string error{};
};

/// What decides how an attempt goes.
json fingerprint_of(const StudyPlan& plan, const StudyExercise& exercise, const std::string& group, std::uint64_t seed,
                    const Context& context) {
    const Result<std::string> scripts = hash_of_scripts(context.root + "/scripts");
    return {{"exercise", hash_of_curriculum(exercise.exercise, context.root)},
            {"scripts", scripts ? scripts.value() : ""},
            {"start", exercise.start},
            {"set", exercise.set},
            {"group", group},
            {"seed", seed},
            {"limit_s", plan.limit_s}};
}

std::string folder_of(const std::string& out, std::size_t exercise, const StudyExercise& given,
                      const std::string& group, std::uint64_t seed) {
    const std::string name = std::filesystem::path(given.exercise).filename().string();
    return out + "/" + std::to_string(exercise + 1) + "-" + name + "-" + group + "-" + std::to_string(seed);
}

std::vector<StudyJob> jobs_of(const StudyPlan& plan, const std::string& out, const Context& context) {
    std::vector<StudyJob> jobs;
    for (std::uint64_t seed = plan.first_seed; seed <= plan.last_seed; ++seed) {
        for (const std::string& group : plan.groups) {
            for (std::size_t i = 0; i < plan.exercises.size(); ++i) {
                const StudyExercise& exercise = plan.exercises[i];
                StudyJob& job = jobs.emplace_back();
                job.exercise = &exercise;
                job.folder = folder_of(out, i, exercise, group, seed);
                job.fingerprint = fingerprint_of(plan, exercise, group, seed, context);
                job.run = {group, seed, {}};
            }
        }
    }
    return jobs;
}

/// Loads each exercise with each surgeon and makes its start.
Result<Start> try_exercise(const StudyPlan& plan, const StudyExercise& exercise, const Context& context) {
    for (const std::string& group : plan.groups) {
        const Result<ExerciseHost> host =
            ExerciseHost::load({exercise.exercise, group, plan.first_seed, exercise.set, context.root});
        if (!host) {
            return host.error();
        }
    }
    return find_start({exercise.exercise, exercise.start, exercise.set, context.root, true});
}

/// The start of each exercise, made once, and the exercises with their surgeons loaded once: mistakes show before the
/// first attempt. An operation begins with its first part; what its parts are decides how an attempt goes, too. What is
/// only judged again needs no start.
Status prepare(const StudyPlan& plan, std::vector<StudyJob>& jobs, bool judge_again, const Context& context) {
    for (const StudyExercise& exercise : plan.exercises) {
        const Result<std::optional<Operation>> operation = load_operation(exercise.exercise, context.root);
        if (!operation) {
            return operation.error();
        }
        if (operation.value() && !exercise.start.empty()) {
            return Error{"start is for exercises, and " + exercise.exercise + " is an operation", plan.name, "none"};
        }
        const bool needs_start = !operation.value() && !judge_again;
        const Result<Start> start = needs_start ? try_exercise(plan, exercise, context) : Result<Start>(Start{});
        if (!start) {
            return start.error();
        }
        json parts = json::array();
        for (const OperationPart& part : operation.value() ? operation.value()->parts : std::vector<OperationPart>{}) {
            parts.push_back(hash_of_curriculum(part.exercise, context.root));
        }
        for (StudyJob& job : jobs) {
            if (job.exercise == &exercise) {
                job.start = start.value();
                job.operation = operation.value();
                if (job.operation) {
                    job.fingerprint["parts"] = parts;
                }
            }
        }
    }
    return success();
}

constexpr const char* done_file = "/study_run.json";  // the last file of an attempt: where it stands, that is whole

bool take_up(StudyJob& job) {
    const Result<std::string> mark = read_whole_file(job.folder + done_file);
    const Result<std::string> report = read_whole_file(job.folder + "/report.json");
    if (!mark || !report || json::parse(mark.value(), nullptr, false) != job.fingerprint) {
        return false;
    }
    job.run.report = json::parse(report.value(), nullptr, false);
    return job.run.report.is_object();
}

/// Report and script error of an attempt at an exercise or operation. What is whole of an operation stays.
Result<std::pair<json, std::string>> run_either(const StudyJob& job, const AttemptOptions& options, bool resume) {
    if (job.operation) {
        const Result<OperationResult> whole = operate({*job.operation, options, "", "", resume});
        return whole ? Result(std::pair(whole.value().report, whole.value().script_error)) : whole.error();
    }
    const Result<AttemptResult> alone = attempt(options);
    return alone ? Result(std::pair(report_of(alone.value()), alone.value().facts.script_error)) : alone.error();
}

void run_job(const StudyPlan& plan, StudyJob& job, const Context& context, bool resume) {
    AttemptOptions options;
    options.exercise = {job.exercise->exercise, job.run.group, job.run.seed, job.exercise->set, context.root};
    options.folder = job.folder;
    options.start = job.start;
    options.drawing = Drawing::none;
    options.limit_s = plan.limit_s;
    options.quiet = true;
    Result<std::pair<json, std::string>> result = run_either(job, options, resume);
    if (!result) {
        job.error = result.error().text();
        return;
    }
    auto [report, script_error] = std::move(result).value();
    job.run.report = std::move(report);
    job.error = std::move(script_error);
    const Status marked = write_file(job.folder + done_file, job.fingerprint.dump() + "\n");
    if (!marked && job.error.empty()) {
        job.error = marked.error().text();
    }
}

Result<Rescore> rescored_job(const StudyJob& job, const Context& context) {
    if (job.operation) {
        return rescore_operation(*job.operation, "", part_folders(job.folder), context.root);
    }
    const Result<Recording> recording = read_recording(recording_path(job.folder));
    return recording ? rescore(recording.value(), judge_of(recording.value(), job.exercise->exercise, context.root))
                     : recording.error();
}

Result<json> judged(const StudyJob& job, const Context& context) {
    Result<Rescore> rescored = rescored_job(job, context);
    if (rescored && !rescored.value().script_error.empty()) {
        return Error{rescored.value().script_error, job.folder, ""};
    }
    return rescored ? Result<json>(std::move(rescored.value().result)) : rescored.error();
}

/// What was recorded, by the rules of today: only what those would have set otherwise is simulated again.
void judge_job(StudyJob& job, const Context& context) {
    Result<json> report = read_json_file(job.folder + "/report.json");
    const Result<json> result = report ? judged(job, context) : report;
    if (!result) {
        job.error = result.error().text();
        return;
    }
    job.run.report = std::move(report).value();
    job.run.report.update(result.value());
}

void do_job(const StudyPlan& plan, StudyJob& job, const StudyOptions& given, const Context& context) {
    if (given.judge_again) {
        judge_job(job, context);
    } else if (!given.resume || !take_up(job)) {
        run_job(plan, job, context, given.resume);
    }
}

/// Runs what is not there already. The first attempt that fails ends the study.
Status run_jobs(const StudyPlan& plan, std::vector<StudyJob>& jobs, const StudyOptions& given, const Context& context) {
    Progress progress("study", given.json);
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::size_t finished = 0;
    std::string error;
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size() && !stop; i = next++) {
            do_job(plan, jobs[i], given, context);
            const std::lock_guard lock(mutex);
            ++finished;
            progress.show(static_cast<double>(finished) / static_cast<double>(jobs.size()),
                          std::to_string(finished) + " of " + std::to_string(jobs.size()) + " attempts");
            if (!jobs[i].error.empty()) {
                error = jobs[i].folder + ": " + jobs[i].error;
                stop = true;
            }
        }
    };
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::thread> workers;
    for (int i = 0; i < (given.jobs > 0 ? given.jobs : cores); ++i) {
        workers.emplace_back(work);
    }
    for (std::thread& worker : workers) {
        worker.join();
    }
    const char* advice = given.judge_again ? "" : "--resume goes on with the other attempts";
    return error.empty() ? success() : Status(Error{error, "study", advice});
}

/// What a study leaves besides its own tables: a reference, or gates that were tried (earlier: on other seeds, or
/// null). Prints where.
Status write_more(const StudyPlan& plan, const std::vector<StudyRun>& runs, const std::string& out, bool quiet,
                  [[maybe_unused]] const json& earlier, const Context& context) {
    if (plan.reference) {
        const std::string file = out + "/cohorts.json";
        if (Status status = write_file(file, cohorts_of(plan, runs, context.root).dump(1) + "\n"); !status) {
            return status;
        }
        std::printf(quiet ? "" : "  reference  %s: copy it to rubrics/\n", file.c_str());
    }
#ifdef RHEXIS_WITH_RECORDS
    if (plan.gates) {
        Result<nlohmann::json> tried = gates_tried(plan, runs, context.root);
        if (tried && !earlier.is_null()) {
            add_earlier(earlier, tried.value());
        }
        const std::string file = out + "/gates_accepted.json";
        Status status = tried ? write_file(file, tried.value().dump(1) + "\n") : Status(tried.error());
        if (!status) {
            return status;
        }
        std::printf(quiet ? "" : "%s  gates      %s: copy it to rubrics/\n", gates_text(tried.value()).c_str(),
                    file.c_str());
    }
#endif
    return success();
}

/// Whether the gates that were accepted are those of today.
int check_gates(const StudyPlan& plan, const Context& context) {
    if (!plan.gates) {
        return complain({"--check is for a study of gates, and " + plan.name + " is none", "", "rhexis study gates"});
    }
#ifdef RHEXIS_WITH_RECORDS
    const Result<std::vector<std::string>> lines = gates_differences(plan, context.root);
    if (!lines) {
        return complain(lines.error());
    }
    for (const std::string& line : lines.value()) {
        std::printf("%s\n", line.c_str());
    }
    if (lines.value().empty()) {
        std::printf("all gates are those that were accepted\n");
    }
    return lines.value().empty() ? done : found_failures;
#else
    return complain({"this program was built without records and their gates", "", ""});
#endif
}

/// "9300-9304" of the seeds of a plan.
Status take_seeds(const std::string& text, StudyPlan& plan) {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    char more = 0;
    if (std::sscanf(text.c_str(), "%" SCNu64 "-%" SCNu64 "%c", &first, &last, &more) != 2 || first > last ||
        first < plan.first_seed || last > plan.last_seed) {
        return Error{"these are no seeds of the study", "--seeds " + text,
                     "FIRST-LAST within " + std::to_string(plan.first_seed) + "-" + std::to_string(plan.last_seed)};
    }
    plan.first_seed = first;
    plan.last_seed = last;
    return success();
}

Result<StudyPlan> plan_of(const StudyOptions& given, const Context& context) {
    Result<StudyPlan> plan = read_study(given.study, context.root);
    const Status taken = plan && !given.seeds.empty() ? take_seeds(given.seeds, plan.value()) : success();
    return taken ? std::move(plan) : Result<StudyPlan>(taken.error());
}

/// The table of --with, or null.
Result<json> earlier_of(const StudyOptions& given, const StudyPlan& plan, const Context& context) {
    if (given.with.empty()) {
        return json();
    }
    if (!plan.gates) {
        return Error{"--with is for a study of gates, and " + plan.name + " is none", "", "rhexis study gates"};
    }
#ifdef RHEXIS_WITH_RECORDS
    return earlier_seeds(given.with, plan, context.root);
#else
    return Error{"this program was built without records and their gates", "", ""};
#endif
}

int study(const StudyOptions& given, const Context& context) {
    const Result<StudyPlan> plan = plan_of(given, context);
    if (!plan) {
        return complain(plan.error());
    }
    if (given.check) {
        return check_gates(plan.value(), context);
    }
    const Result<json> earlier = earlier_of(given, plan.value(), context);
    if (!earlier) {
        return complain(earlier.error());
    }
    const std::string out = given.out.empty() ? "runs/study-" + plan.value().name : given.out;
    const Result<FolderLock> lock = FolderLock::take(out);
    if (!lock) {
        return complain(lock.error());
    }
    std::vector<StudyJob> jobs = jobs_of(plan.value(), out, context);
    Status status = prepare(plan.value(), jobs, given.judge_again, context);
    if (status && !given.judge_again) {
        status = prepare_folder(out);
    }
    if (!status) {
        return complain(status.error());
    }
    status = run_jobs(plan.value(), jobs, given, context);
    if (!status) {
        return complain(status.error(), found_failures);
    }
    std::vector<StudyRun> runs;
    for (StudyJob& job : jobs) {
        runs.push_back(std::move(job.run));
    }
    nlohmann::json result = study_result(plan.value(), runs);
    const Result<std::string> groups = read_whole_file(context.root + "/scripts/surgeons/groups.lua");
    result["groups_sha256"] = groups ? sha256_hex(groups.value()) : "";
    const std::string tables = out + (given.judge_again ? "/judged_again" : "/study");
    status = write_file(tables + ".json", result.dump(2) + "\n");
    if (status) {
        status = write_file(tables + ".md", study_text(result));
    }
    if (!status) {
        return complain(status.error());
    }
    if (given.json) {
        std::cout << result.dump(2) << '\n';
    } else {
        std::printf("%s\n  tables     %s.md\n  numbers    %s.json\n", study_text(result).c_str(), tables.c_str(),
                    tables.c_str());
    }
    status = write_more(plan.value(), runs, out, given.json, earlier.value(), context);
    return status ? done : complain(status.error());
}

}  // namespace

void add_study(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("study", "Compare groups of virtual surgeons");
    command->footer(study_help);
    auto given = std::make_shared<StudyOptions>();
    command->add_option("study", given->study, "File, or name of one in studies/")->required();
    command->add_option("--out", given->out, "Folder for everything [runs/study-NAME]");
    command->add_option("--jobs", given->jobs, "Attempts at a time [one per core]")->check(CLI::Range(1, 64));
    CLI::Option* resume =
        command->add_flag("--resume", given->resume, "Keep the attempts that are whole in the folder");
    command->add_flag("--judge-again", given->judge_again, "Simulate nothing: judge the attempts of the folder anew")
        ->excludes(resume);
    CLI::Option* check = command->add_flag("--check", given->check,
                                           "Of a study of gates: simulate nothing, compare with what was accepted");
    command->add_option("--seeds", given->seeds, "FIRST-LAST: these of its seeds only")->excludes(check);
    command->add_option("--with", given->with, "Of a study of gates: a table of earlier seeds, which is added to")
        ->excludes(check);
    command->add_flag("--json", given->json, "Print study.json on stdout instead of tables");
    command->callback([given, &context] { context.status = study(*given, context); });
}

}  // namespace rhexis::cli
