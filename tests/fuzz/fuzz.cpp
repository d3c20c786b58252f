// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis_fuzz: spoilt curricula and recordings. No crash, no hang, no file outside its own folder. docs/fuzz.md.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>

#include "fuzz/curricula.hpp"
#include "fuzz/recordings.hpp"
#include "trial/places.hpp"

namespace rhexis::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t many_steps = 1000;

struct Options {
    std::uint64_t curricula = 200;
    std::uint64_t recordings = 200;
    std::uint64_t seed = 1;
    std::uint64_t first = 1;
    unsigned limit_s = 60;
};

/// Path, size and time of every file that a run might touch by mistake.
std::map<std::string, std::string> listing(const std::string& root) {
    std::map<std::string, std::string> files;
    for (const char* folder : {"curricula", "scripts", "assets"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root + "/" + folder)) {
            if (entry.is_regular_file()) {
                files[entry.path().string()] = std::to_string(entry.file_size()) + " " +
                                               std::to_string(entry.last_write_time().time_since_epoch().count());
            }
        }
    }
    return files;
}

/// What lies in a folder, its own entries only.
std::map<std::string, std::string> names_in(const std::string& folder) {
    std::map<std::string, std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names[entry.path().filename().string()] = "";
    }
    return names;
}

/// Prints a table of outcomes; returns the number of faults.
int tell(const char* what, const std::vector<Told>& all, double seconds) {
    std::map<std::string, std::uint64_t> kinds;
    std::uint64_t long_enough = 0;
    int faults = 0;
    for (const Told& told : all) {
        ++kinds[told.outcome.kind];
        long_enough += told.outcome.steps >= many_steps ? 1 : 0;
        const bool dead = told.outcome.kind == "crashed" || told.outcome.kind == "hung";
        if (!told.outcome.fault.empty() || dead) {
            ++faults;
            std::printf("FAULT: %s %llu: %s: %s\n", what, static_cast<unsigned long long>(told.number),
                        told.outcome.kind.c_str(), told.outcome.fault.c_str());
        }
    }
    std::printf("%s: %zu cases:", what, all.size());
    for (const auto& [kind, count] : kinds) {
        std::printf(" %s %llu", kind.c_str(), static_cast<unsigned long long>(count));
    }
    if (std::string(what) == "curricula" && !all.empty()) {
        std::printf("; %.1f %% ran at least %llu steps",
                    100.0 * static_cast<double>(long_enough) / static_cast<double>(all.size()),
                    static_cast<unsigned long long>(many_steps));
    }
    std::printf("; %d faults; %.0f s\n", faults, seconds);
    return faults;
}

int timed(const char* what, const std::function<std::vector<Told>()>& cases) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Told> all = cases();
    return tell(what, all, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

int run(const Options& options) {
    const std::string root = fs::absolute(find_root()).string();
    char pattern[] = "/tmp/rhexis-fuzz-XXXXXX";
    const std::string place = mkdtemp(pattern);
    const std::string work = place + "/work";
    const std::string elsewhere = place + "/elsewhere";  // where a file with a relative name would appear
    fs::create_directories(work);
    fs::create_directories(elsewhere);
    fs::current_path(elsewhere);
    const auto before = listing(root);
    int faults = 0;
    if (options.curricula > 0) {
        const Result<std::vector<Base>> bases = make_bases(root, 150);
        if (!bases) {
            std::fprintf(stderr, "rhexis_fuzz: %s\n", bases.error().text().c_str());
            return 2;
        }
        CurriculaPlan plan{root, work, options.seed};
        plan.bases = &bases.value();
        faults += timed("curricula", [&] {
            return run_batches(options.first, options.curricula, options.limit_s,
                               [&](std::uint64_t n) { return curriculum_case(plan, n); });
        });
    }
    if (options.recordings > 0) {
        const Result<std::vector<std::string>> recordings = make_recordings(root, work);
        if (!recordings) {
            std::fprintf(stderr, "rhexis_fuzz: %s\n", recordings.error().text().c_str());
            return 2;
        }
        const RecordingsPlan plan{work, options.seed, &recordings.value()};
        faults += timed("recordings", [&] {
            return run_batches(options.first, options.recordings, options.limit_s,
                               [&](std::uint64_t n) { return recording_case(plan, n); });
        });
    }
    const bool stray = listing(root) != before || !names_in(elsewhere).empty() || names_in(place).size() != 2;
    std::printf("files outside its own folder: %s\n", stray ? "SOME" : "none");
    fs::current_path("/");
    fs::remove_all(place);
    return faults > 0 || stray ? 1 : 0;
}

/// --curricula, --recordings, --seed, --first, --limit, each with a whole number. False on anything else.
bool read_options(int argc, char** argv, Options& options) {
    std::uint64_t limit = options.limit_s;
    const std::map<std::string, std::uint64_t*> known{{"--curricula", &options.curricula},
                                                      {"--recordings", &options.recordings},
                                                      {"--seed", &options.seed},
                                                      {"--first", &options.first},
                                                      {"--limit", &limit}};
    for (int i = 1; i < argc; i += 2) {
        const auto option = known.find(argv[i]);
        char* end = nullptr;
        const std::uint64_t value = i + 1 < argc ? std::strtoull(argv[i + 1], &end, 10) : 0;
        if (option == known.end() || end == nullptr || end == argv[i + 1] || *end != '\0') {
            return false;
        }
        *option->second = value;
    }
    options.limit_s = static_cast<unsigned>(limit);
    return true;
}

}  // namespace
}  // namespace rhexis::fuzz

int main(int argc, char** argv) {
    rhexis::fuzz::Options options;
    if (!rhexis::fuzz::read_options(argc, argv, options)) {
        std::fprintf(stderr,
                     "rhexis_fuzz [--curricula N] [--recordings N] [--seed N] [--first NUMBER] [--limit SECONDS]\n"
                     "Spoilt curricula and recordings: no crash, no hang, no file outside a folder of its own.\n");
        return 2;
    }
    return rhexis::fuzz::run(options);
}
