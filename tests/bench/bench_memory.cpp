// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_memory.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/output_file.hpp"

namespace rhexis::bench {
namespace {

constexpr double allowed_mb = 60.0;  ///< over an empty scene

/// VmHWM of a process now [kB]; 0 once it has ended.
double high_water_kb(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) {
            return std::stod(line.substr(6));
        }
    }
    return 0.0;
}

/// Runs this program with these arguments, silently. Returns its peak memory [MB], not a number when it failed. The
/// peak is watched, not asked for afterwards: the figure that wait4 gives counts this process too, up to the exec.
double peak_mb(const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>("rhexis")};
    for (const std::string& argument : arguments) {
        words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    posix_spawn_file_actions_t silent;
    ::posix_spawn_file_actions_init(&silent);
    ::posix_spawn_file_actions_addopen(&silent, 1, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&silent, 2, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    const int failed = ::posix_spawn(&process, "/proc/self/exe", &silent, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&silent);
    if (failed != 0) {
        return NAN;
    }
    double peak = 0.0;
    int status = 0;
    while (::waitpid(process, &status, WNOHANG) == 0) {
        peak = std::max(peak, high_water_kb(process));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 1e-3 * peak : NAN;
}

/// A folder that goes when this does.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("rhexis-memory-" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

/// Nothing to be simulated, and the same picture but for the lens: what a picture needs is not what a scene needs.
constexpr const char* empty_exercise =
    "return exercise { title = \"Nothing\", tissues = { \"iris\", \"cornea\" }, instruments = { \"phaco\" },\n"
    "    steps = { step \"wait\" { done = \"time_s >= 1\" } } }\n";

/// Long enough to be watched.
constexpr const char* idle_script = "local start = os.clock() while os.clock() - start < 0.2 do end\n";

nlohmann::json difference(const std::string& name, double larger, double smaller) {
    return {{"name", "memory/" + name},
            {"measured", larger - smaller},
            {"gate", allowed_mb},
            {"unit", "MB"},
            {"passed", larger - smaller <= allowed_mb}};
}

nlohmann::json run_memory(const BenchOptions& options) {
    const Folder folder;
    const std::string empty = folder.path / "empty";
    const std::string out = folder.path / "out";
    std::filesystem::create_directories(empty);
    nlohmann::json rows = nlohmann::json::array();
    const std::string limit = options.quick ? "3" : "600";
    const auto measure = [&](const std::string& name, std::vector<std::string> arguments) {
        if (arguments[0] == "run") {
            arguments.insert(arguments.end(), {"--out", out});
        }
        const double peak = peak_mb(arguments);
        rows.push_back({{"name", "memory/" + name}, {"peak", peak}, {"unit", "MB"}, {"passed", std::isfinite(peak)}});
        return peak;
    };
    const std::string idle = folder.path / "idle.lua";
    if (!write_file(empty + "/curriculum.lua", empty_exercise) || !write_file(idle, idle_script)) {
        return {{{"name", "memory"}, {"failure", "cannot write to " + empty}, {"passed", false}}};
    }
    const double program = measure("program", {"lua", idle});
    const double bare = measure("empty_scene", {"run", empty, "--surgeon", "none"});
    const double groove = measure("groove", {"run", "groove", "--limit", limit});
    const double blind = measure("groove_without_pictures", {"run", "groove", "--no-pictures", "--limit", "3"});
    rows.push_back(difference("groove_over_empty_scene", groove, bare));
    rows.push_back(difference("groove_without_pictures_over_program", blind, program));
    return rows;
}

}  // namespace

std::vector<BenchCase> memory_cases() {
    return {{"memory", "peak memory of the groove exercise over an empty scene and over the bare program", run_memory}};
}

}  // namespace rhexis::bench
