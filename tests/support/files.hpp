// SPDX-License-Identifier: GPL-3.0-or-later
// For tests of files: a folder, pictures, and a disk that fills up.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>

#include "flow/frame.hpp"

namespace rhexis::files {

/// A folder of its own that goes away again.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("rhexis-files-" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string operator/(const char* name) const { return (path / name).string(); }
    [[nodiscard]] int files() const {
        return static_cast<int>(
            std::distance(std::filesystem::directory_iterator(path), std::filesystem::directory_iterator()));
    }
};

inline Image ramp(int width, int height, int shift = 0) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        for (int c = 0; c < 3; ++c) {
            image.rgb.push_back(static_cast<unsigned char>((i * (c + 1) + shift) % 251));
        }
    }
    return image;
}

/// Files of this process end at `bytes`, as on a full disk.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

}  // namespace rhexis::files
