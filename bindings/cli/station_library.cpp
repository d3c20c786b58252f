// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/station_library.hpp"

#include <filesystem>
#include <string>

#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

/// what: it is, for errors.
Result<void*> load(const char* library, const std::string& what) {
    std::error_code unknown;
    const std::filesystem::path folder = std::filesystem::canonical(program_path(), unknown).parent_path();
    std::string tried;
    for (const std::filesystem::path& path : {folder / library, folder / "../lib/rhexis" / library}) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) {
            tried += (tried.empty() ? "" : ", ") + path.string();
            continue;
        }
        void* opened = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (opened == nullptr) {
            return Error{what + " cannot be loaded: " + ::dlerror(), path.string(), "the Debian packages of deps.txt"};
        }
        return opened;
    }
    return Error{"this program comes without " + what, tried, std::string(library) + " in one of these places"};
}

}  // namespace

Result<void*> load_station() { return load("rhexis-window.so", "its window"); }

Result<void*> load_tracking() { return load("rhexis-track.so", "its tracking"); }

void add_window_size(CLI::App& command, int& width, int& height) {
    command.add_option("--width", width, "Of the window [pixels]")->check(CLI::Range(160, 4096))->capture_default_str();
    command.add_option("--height", height, "Of the window [pixels]")
        ->check(CLI::Range(120, 4096))
        ->capture_default_str();
}

}  // namespace rhexis::cli
