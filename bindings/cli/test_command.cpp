// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis test: scenario tests of exercises, each on an eye of its own.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <list>
#include <mutex>
#include <thread>

#include "base/output_file.hpp"
#include "cli/command.hpp"
#include "cli/coverage.hpp"
#include "cli/junit.hpp"
#include "trial/places.hpp"
#include "trial/progress.hpp"
#include "trial/starts.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* test_help =
    "A scenario test leads instruments from place to place and says what must come of it (docs/scenarios.md).\n"
    "\n"
    "  rhexis test groove                          the tests of an exercise in curricula/\n"
    "  rhexis test my_exercise/                    tests/*.lua and *_test.lua in a folder and below it\n"
    "  rhexis test my_exercise/tests/iris.lua --filter twin\n"
    "  rhexis test groove --junit results.xml --require-all\n"
    "\n"
    "At the end stand the error events that no test raised, or not with and without recovery, or that have no silent "
    "twin.";

struct TestOptions {
    std::vector<std::string> paths;
    std::string junit;
    std::string results;
    std::string filter;
    int jobs = 0;
    double longest_s = 0.0;  ///< 0: no limit
    bool require_all = false;
};

struct Job {
    FinishedScenario scenario;
    Start start{};
    bool finished = false;
};

bool wanted(const nlohmann::json& scenario, const std::string& filter) {
    return scenario.at("name").get<std::string>().find(filter) != std::string::npos;
}

/// The files that the paths stand for, each once.
Result<std::vector<std::string>> all_paths(const TestOptions& given, const std::string& root) {
    std::vector<std::string> all;
    for (const std::string& path : given.paths) {
        const Result<std::vector<std::string>> found = scenario_paths(path, root);
        if (!found) {
            return found.error();
        }
        for (const std::string& file : found.value()) {
            if (std::find(all.begin(), all.end(), file) == all.end()) {
                all.push_back(file);
            }
        }
    }
    return all;
}

/// Everything that will run, checked as far as it can be without simulating.
class Plan {
public:
    Status read(const TestOptions& given, const std::string& root) {
        const Result<std::vector<std::string>> paths = all_paths(given, root);
        if (!paths) {
            return paths.error();
        }
        for (const std::string& path : paths.value()) {
            Result<ScenarioFile> file = read_scenarios(path, root);
            if (!file) {
                return file.error();
            }
            files_.push_back(std::move(file).value());
            Status added = add(files_.back(), given.filter, root);
            if (!added) {
                return added;
            }
        }
        if (jobs.empty()) {
            return Error{"no scenario has '" + given.filter + "' in its name", "--filter", ""};
        }
        return success();
    }

    /// Makes the states that the scenarios start from.
    Status prepare(const std::string& root) {
        for (Job& job : jobs) {
            const ScenarioFile& file = *job.scenario.file;
            const nlohmann::json& scenario = file.scenarios.at(job.scenario.number);
            const Result<Start> start = find_start(start_of(file, scenario, root));
            if (!start) {
                return start.error();
            }
            job.start = start.value();
        }
        return success();
    }

    std::vector<Job> jobs;

private:
    Status add(const ScenarioFile& file, const std::string& filter, const std::string& root) {
        for (std::size_t i = 0; i < file.scenarios.size(); ++i) {
            if (wanted(file.scenarios.at(i), filter)) {
                Status good = check_scenario(file, file.scenarios.at(i), root);
                if (!good) {
                    return good;
                }
                Job& job = jobs.emplace_back();
                job.scenario.file = &file;
                job.scenario.number = i;
            }
        }
        return success();
    }

    std::list<ScenarioFile> files_;  ///< jobs point to them
};

/// Runs the jobs on several threads; `report` is called for each in their order, as soon as all before it are done.
template <typename Report>
void run_all(std::vector<Job>& jobs, int threads, const std::string& root, const Report& report) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::condition_variable done;
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            ScenarioResult result;
            try {
                result = run_scenario(*jobs[i].scenario.file, jobs[i].scenario.number, jobs[i].start, root);
            } catch (const std::exception& error) {
                result.error = std::string("internal error: ") + error.what();
            }
            const std::lock_guard lock(mutex);
            jobs[i].scenario.result = std::move(result);
            jobs[i].finished = true;
            done.notify_all();
        }
    };
    std::vector<std::thread> workers;
    for (int i = 0; i < std::min(threads, static_cast<int>(jobs.size())); ++i) {
        workers.emplace_back(work);
    }
    for (const Job& job : jobs) {
        std::unique_lock lock(mutex);
        done.wait(lock, [&] { return job.finished; });
        lock.unlock();
        report(job);
    }
    for (std::thread& worker : workers) {
        worker.join();
    }
}

void print_result(const FinishedScenario& scenario) {
    const ScenarioResult& result = scenario.result;
    std::printf("  %s  %s  (%.1f s simulated)\n", result.passed() ? "ok  " : "FAIL",
                scenario.file->scenarios.at(scenario.number).at("name").get<std::string>().c_str(), result.simulated_s);
    for (const ScenarioFailure& failure : result.failures) {
        std::printf("        %s: %s\n", failure.where.c_str(), failure.message.c_str());
    }
    if (!result.error.empty()) {
        std::printf("        %s\n", result.error.c_str());
    }
}

struct Totals {
    int passed = 0;
    int failed = 0;
    int too_long = 0;
    double simulated_s = 0.0;
    double cpu_s = 0.0;
};

Totals run_jobs(Plan& plan, const TestOptions& given, const Context& context) {
    Totals totals;
    Progress progress("test", false);
    const ScenarioFile* file = nullptr;
    double count = 0.0;
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    progress.show(0.0, "");
    run_all(plan.jobs, given.jobs > 0 ? given.jobs : cores, context.root, [&](const Job& job) {
        progress.clear();
        if (job.scenario.file != file) {
            file = job.scenario.file;
            std::printf("%s\n", file->path.c_str());
        }
        print_result(job.scenario);
        std::fflush(stdout);
        if (given.longest_s > 0.0 && job.scenario.result.simulated_s > given.longest_s + 1e-6) {
            ++totals.too_long;
            std::printf("        longer than %g s\n", given.longest_s);
        }
        (job.scenario.result.passed() ? totals.passed : totals.failed) += 1;
        totals.simulated_s += job.scenario.result.simulated_s;
        totals.cpu_s += job.scenario.result.cpu_s;
        progress.show(++count / static_cast<double>(plan.jobs.size()), std::to_string(totals.failed) + " failed");
    });
    return totals;
}

Status write_junit(const Plan& plan, const std::string& path) {
    std::vector<FinishedScenario> scenarios;
    for (const Job& job : plan.jobs) {
        scenarios.push_back(job.scenario);
    }
    return write_file(path, junit_xml(scenarios));
}

/// What the exercise found in each scenario, for who wants to look on.
Status write_results(const Plan& plan, const std::string& path) {
    nlohmann::json list = nlohmann::json::array();
    for (const Job& job : plan.jobs) {
        const FinishedScenario& one = job.scenario;
        list.push_back({{"file", one.file->path},
                        {"exercise", one.file->exercise},
                        {"name", one.file->scenarios.at(one.number).at("name")},
                        {"passed", one.result.passed()},
                        {"simulated_s", one.result.simulated_s},
                        {"found", one.result.findings}});
    }
    return write_file(path, list.dump(1) + "\n");
}

Coverage coverage_of(const Plan& plan) {
    Coverage coverage;
    for (const Job& job : plan.jobs) {
        coverage.add(job.scenario.file->exercise, job.scenario.result);
    }
    return coverage;
}

int test(const TestOptions& given, const Context& context) {
    Plan plan;
    Status status = plan.read(given, context.root);
    if (status) {
        status = plan.prepare(context.root);
    }
    if (!status) {
        return complain(status.error());
    }
    const Totals totals = run_jobs(plan, given, context);
    std::printf("%d passed, %d failed; %.1f s simulated, %.1f s of CPU\n", totals.passed, totals.failed,
                totals.simulated_s, totals.cpu_s);
    if (totals.too_long > 0) {
        std::printf("%d longer than %g s\n", totals.too_long, given.longest_s);
    }
    int result = totals.failed + totals.too_long > 0 ? found_failures : done;
    if (given.filter.empty()) {  // a part of the tests says nothing about what all of them lack
        const Coverage coverage = coverage_of(plan);
        for (const std::string& line : coverage.lines()) {
            std::printf("%s\n", line.c_str());
        }
        result = given.require_all && !coverage.complete() ? found_failures : result;
    }
    Status written = given.junit.empty() ? success() : write_junit(plan, given.junit);
    written = written && !given.results.empty() ? write_results(plan, given.results) : written;
    return written ? result : complain(written.error());
}

}  // namespace

void add_test(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("test", "Run scenario tests of exercises");
    command->footer(test_help);
    auto given = std::make_shared<TestOptions>();
    command->add_option("path", given->paths, "Scenario files, folders, or names in curricula/")->required();
    command->add_option("--junit", given->junit, "Write the results to this file as JUnit XML");
    command->add_option("--results", given->results,
                        "Write what the exercise found in each scenario to this file, as JSON");
    CLI::Option* filter = command->add_option("--filter", given->filter, "Only scenarios with this text in their name");
    command->add_option("--jobs", given->jobs, "Scenarios to run at once [processor cores]")->check(CLI::Range(1, 64));
    command->add_option("--longest", given->longest_s, "Fail when a scenario simulates more seconds [no limit]")
        ->check(CLI::PositiveNumber);
    command->add_flag("--require-all", given->require_all, "Fail when an error event lacks one of its tests")
        ->excludes(filter);
    command->callback([given, &context] { context.status = test(*given, context); });
}

}  // namespace rhexis::cli
