// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace rhexis {
namespace {

namespace fs = std::filesystem;

/// Who holds a lock on it, from the system's list; empty: it does not say.
std::string holder_of(int descriptor) {
    struct stat folder {};
    if (::fstat(descriptor, &folder) != 0) {
        return {};
    }
    const std::string inode = ":" + std::to_string(folder.st_ino);
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {  // 1: FLOCK ADVISORY WRITE 4711 fe:00:1234 0 EOF
        std::istringstream words(line);
        std::string number;
        std::string kind;
        std::string mode;
        std::string access;
        std::string process;
        std::string place;
        words >> number >> kind >> mode >> access >> process >> place;
        if (kind == "FLOCK" && place.ends_with(inode)) {
            return " (process " + process + ")";
        }
    }
    return {};
}

}  // namespace

Result<FolderLock> FolderLock::take(const std::string& folder) {
    std::error_code failed;
    const bool there = fs::exists(folder, failed);
    fs::create_directories(folder, failed);
    if (failed) {
        return Error{"cannot make this folder: " + failed.message(), folder, "a folder that can be written"};
    }
    FolderLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC), there ? "" : folder);
    if (lock.descriptor_ < 0) {
        return Error{std::string("cannot be opened: ") + std::strerror(errno), folder, "a folder that can be written"};
    }
    if (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        return Error{"another run writes into this folder" + holder_of(lock.descriptor_), folder,
                     "another folder, or wait until it is done"};
    }
    return lock;
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), made_(std::exchange(other.made_, {})) {}

FolderLock::~FolderLock() {
    if (descriptor_ < 0) {
        return;
    }
    if (!made_.empty()) {
        ::rmdir(made_.c_str());  // only if it is empty
    }
    ::close(descriptor_);
}

}  // namespace rhexis
