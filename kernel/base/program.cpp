// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/program.hpp"

#include <sys/auxv.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

namespace rhexis {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> places_of(const std::string& library) {
    constexpr int levels = 5;  // a test lies so deep in a build at most
    std::error_code unknown;
    fs::path folder = fs::canonical(program_path(), unknown).parent_path();
    std::vector<fs::path> places{folder / library, folder / "../lib/rhexis" / library};
    for (int level = 0; level < levels; ++level) {
        folder = folder.parent_path();
        places.push_back(folder / "bindings/cli" / library);
    }
    return places;
}

}  // namespace

std::string program_path() {
    constexpr const char* of_system = "/proc/self/exe";
    if (::access(of_system, R_OK) == 0) {
        return of_system;
    }
    const auto* const called = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
    std::error_code failed;
    const fs::path path = called != nullptr ? fs::canonical(called, failed) : fs::path();
    return failed ? std::string() : path.string();
}

Result<void*> load_library(const std::string& library, const std::string& what) {
    const std::vector<fs::path> places = places_of(library);
    for (const fs::path& path : places) {
        std::error_code ignored;
        if (!fs::exists(path, ignored)) {
            continue;
        }
        void* opened = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (opened == nullptr) {
            return Error{what + " cannot be loaded: " + ::dlerror(), path.string(), "the Debian packages of deps.txt"};
        }
        return opened;
    }
    return Error{"this program comes without " + what, places[0].string() + ", " + places[1].string(),
                 library + " in one of these places"};
}

}  // namespace rhexis
