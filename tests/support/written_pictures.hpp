// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures to be written, and a disk that fills up.
#pragma once

#include <sys/resource.h>

#include <csignal>

#include "flow/frame.hpp"

namespace rhexis::test {

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

}  // namespace rhexis::test
