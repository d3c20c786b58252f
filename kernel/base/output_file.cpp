// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace rhexis {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  ///< as many as Linux follows

std::string folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

}  // namespace

Result<OutputPlace> output_place(const std::string& path) {
    OutputPlace place{path};
    struct stat what {};
    for (int i = 0; i < most_links; ++i) {
        if (::lstat(place.path.c_str(), &what) != 0) {
            return place;  // what is wrong with its folder shows when it is opened
        }
        // a link of /proc to a pipe or a device leads to no path: what it is of counts
        struct stat target {};
        const bool leads_on = S_ISLNK(what.st_mode);
        if (leads_on && ::stat(place.path.c_str(), &target) == 0 && !S_ISREG(target.st_mode)) {
            what = target;
        } else if (leads_on) {
            std::error_code failed;
            const fs::path next = fs::read_symlink(place.path, failed);
            if (failed) {
                return cannot_write(path, failed.value());
            }
            place.path = next.is_absolute() ? next.string() : (fs::path(folder_of(place.path)) / next).string();
            continue;
        }
        if (S_ISDIR(what.st_mode)) {
            return Error{"this is a folder", path, "the name of a file"};
        }
        place.plain = S_ISREG(what.st_mode);
        place.mode = what.st_mode & 07777;
        return place;
    }
    return Error{"cannot write: its links go in circles", path, ""};
}

Error cannot_write(const std::string& path, int code) {
    const std::string folder = folder_of(path);
    const std::string why = std::strerror(code);
    std::error_code ignored;
    if (code == ENOENT && !fs::exists(folder, ignored)) {
        return {"cannot write: there is no folder " + folder, path, "a file in a folder that is there"};
    }
    if (code == EACCES || code == EROFS || code == ENOTDIR) {
        return {"cannot write: no file can be made in the folder " + folder + " (" + why + ")", path,
                "a file in a folder that can be written"};
    }
    return {"cannot write: " + why, path, ""};
}

Status write_bytes(int descriptor, const std::string& path, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return cannot_write(path, errno);
        }
        bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return success();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : place_(std::move(other.place_)),
      unfinished_(std::exchange(other.unfinished_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!unfinished_.empty()) {
        ::unlink(unfinished_.c_str());
    }
}

Result<OutputFile> OutputFile::create(const std::string& path) {
    Result<OutputPlace> place = output_place(path);
    if (!place) {
        return place.error();
    }
    OutputFile file(std::move(place).value());
    const std::string name = file.place_.plain  // others may write it too
                                 ? file.place_.path + "." + std::to_string(::getpid()) + ".unfinished"
                                 : file.place_.path;
    const int how = file.place_.plain ? O_CREAT | O_TRUNC : 0;
    file.descriptor_ = ::open(name.c_str(), O_WRONLY | O_CLOEXEC | how, file.place_.mode);
    if (file.descriptor_ < 0) {
        return cannot_write(file.place_.path, errno);
    }
    if (file.place_.plain) {
        file.unfinished_ = name;
    }
    return file;
}

Status OutputFile::write(std::string_view bytes) { return write_bytes(descriptor_, place_.path, bytes); }

Status OutputFile::finish() {
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0) {
        return cannot_write(place_.path, errno);
    }
    if (place_.plain) {
        if (std::rename(unfinished_.c_str(), place_.path.c_str()) != 0) {
            return cannot_write(place_.path, errno);
        }
        unfinished_.clear();
    }
    return success();
}

Status write_file(const std::string& path, std::string_view content) {
    Result<OutputFile> file = OutputFile::create(path);
    if (!file) {
        return file.error();
    }
    const Status written = file.value().write(content);
    return written ? file.value().finish() : written;
}

}  // namespace rhexis
