// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis bench: benchmarks by name. Compiled only into a program that has them.
#include "bench/bench.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>

#include "base/near_names.hpp"
#include "cli/command.hpp"
#include "trial/progress.hpp"

namespace rhexis::cli {
namespace {

using bench::BenchCase;
using bench::BenchOptions;
using nlohmann::json;

constexpr const char* bench_help =
    "Without a name all are run.\n"
    "\n"
    "  rhexis bench --list\n"
    "  rhexis bench stability\n"
    "  rhexis bench --json > bench.json";

struct BenchArguments {
    std::vector<std::string> names;
    bool list = false;
    bool json = false;
    BenchOptions options;
};

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown";
}

json machine() {
    utsname name{};
    ::uname(&name);
    return {{"processor", processor()},
            {"cores", ::sysconf(_SC_NPROCESSORS_ONLN)},
            {"system", name.sysname},
            {"release", name.release},
            {"version", RHEXIS_VERSION}};
}

int list(const std::vector<BenchCase>& cases, bool as_json) {
    if (as_json) {
        json told = json::array();
        for (const BenchCase& one : cases) {
            json entry = {{"name", one.name}, {"summary", one.summary}};
            if (one.about.is_object()) {
                entry["about"] = one.about;
            }
            told.push_back(std::move(entry));
        }
        std::cout << told.dump(2) << '\n';
        return done;
    }
    for (const BenchCase& one : cases) {
        std::printf("%-28s %s\n", one.name.c_str(), one.summary.c_str());
    }
    return done;
}

/// The named cases, in the order of the list; all when none is named.
Result<std::vector<BenchCase>> chosen(const std::vector<BenchCase>& cases, const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const BenchCase& one : cases) {
        known.push_back(one.name);
    }
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            return Error{"there is no benchmark " + name, "bench", suggestion(name, known)};
        }
    }
    std::vector<BenchCase> wanted;
    for (const BenchCase& one : cases) {
        if (names.empty() || std::find(names.begin(), names.end(), one.name) != names.end()) {
            wanted.push_back(one);
        }
    }
    return wanted;
}

std::string shown(const json& value) {
    if (!value.is_number_float()) {
        return value.is_string() ? value.get<std::string>() : value.dump();
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value.get<double>());
    return text;
}

void print_row(const json& row) {
    std::printf("%-36s", row.value("name", "").c_str());
    for (const auto& [key, value] : row.items()) {
        if (key != "name") {
            std::printf("  %s %s", key.c_str(), shown(value).c_str());
        }
    }
    std::printf("\n");
    std::fflush(stdout);  // what is measured is kept, even if a later benchmark is broken off
}

int bench(const BenchArguments& given) {
    const std::vector<BenchCase> cases = bench::bench_cases();
    if (given.list) {
        return list(cases, given.json);
    }
    const Result<std::vector<BenchCase>> wanted = chosen(cases, given.names);
    if (!wanted) {
        return complain(wanted.error());
    }
    json rows = json::array();
    int status = done;
    Progress progress("bench");
    for (std::size_t i = 0; i < wanted.value().size(); ++i) {
        const BenchCase& one = wanted.value()[i];
        BenchOptions options = given.options;
        options.progress = [&](double share) {
            progress.show((static_cast<double>(i) + share) / static_cast<double>(wanted.value().size()), one.name);
        };
        options.progress(0.0);
        for (const json& row : one.run(options)) {
            status = row.value("passed", true) ? status : found_failures;
            rows.push_back(row);
            if (!given.json) {
                print_row(row);
            }
        }
    }
    if (given.json) {
        std::cout << json{{"machine", machine()}, {"cases", rows}}.dump(2) << '\n';
    }
    return status;
}

}  // namespace

void add_bench(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("bench", "Run benchmarks");
    command->footer(bench_help);
    auto given = std::make_shared<BenchArguments>();
    command->add_option("name", given->names, "Which ones");
    command->add_flag("--list", given->list, "Name them");
    command->add_flag("--json", given->json, "Print machine and rows as JSON");
    command->add_flag("--quick", given->options.quick, "Smaller and fewer: does it run at all");
    command->add_option("--repeats", given->options.repeats, "The best of so many counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--threads", given->options.threads, "Threads of the kernel")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command->callback([given, &context] { context.status = bench(*given); });
}

}  // namespace rhexis::cli
