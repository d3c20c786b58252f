// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/kept_states.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "trial/places.hpp"

namespace rhexis {
namespace {

namespace fs = std::filesystem;

constexpr const char* inside = "/states";

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

/// Of this user alone, for others could put their own states there.
Result<std::string> among_temporary_files() {
    std::error_code failed;
    const fs::path all = fs::temp_directory_path(failed);
    const std::string own = (all / ("rhexis-" + std::to_string(::geteuid()))).string();
    ::mkdir(own.c_str(), 0700);
    struct stat what {};
    if (failed || ::lstat(own.c_str(), &what) != 0 || !S_ISDIR(what.st_mode) || what.st_uid != ::geteuid()) {
        return Error{"there is no folder to keep states in: neither in the home folder nor in " + all.string(), "",
                     "--cache FOLDER, or RHEXIS_CACHE"};
    }
    const Status status = prepare_folder(own + inside);
    return status ? Result<std::string>(own + inside) : status.error();
}

}  // namespace

Result<std::string> folder_of_states() {
    if (const std::string named = environment("RHEXIS_CACHE"); !named.empty()) {
        const Status status = prepare_folder(named + inside);
        return status ? Result<std::string>(named + inside) : status.error();
    }
    for (const auto& [base, beneath] :
         {std::pair(environment("XDG_CACHE_HOME"), "/rhexis"), std::pair(environment("HOME"), "/.cache/rhexis")}) {
        const std::string folder = base + beneath + inside;
        if (!base.empty() && prepare_folder(folder)) {
            return folder;
        }
    }
    return among_temporary_files();
}

Turn::Turn(const std::string& path) : file_(::open((path + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ >= 0) {
        ::flock(file_, LOCK_EX);
    }
}

Turn::~Turn() {
    if (file_ >= 0) {
        ::close(file_);
    }
}

}  // namespace rhexis
