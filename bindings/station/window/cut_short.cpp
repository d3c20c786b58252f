// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/cut_short.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace rhexis::station {
namespace {

constexpr int bad_input = 2;  ///< as for everything that is missing

/// What is to be said at the end of the process, for the system asks nothing else then; empty: nothing.
struct LastWords {
    std::mutex mutex;
    std::string text;
};

LastWords& last_words() {
    static LastWords words;
    return words;
}

void say_them() {
    LastWords& words = last_words();
    const std::lock_guard lock(words.mutex);
    if (!words.text.empty()) {
        std::fputs(words.text.c_str(), stderr);
        std::fflush(stderr);
        ::_exit(bad_input);
    }
}

void set_last_words(const std::string& text) {
    const std::lock_guard lock(last_words().mutex);
    last_words().text = text;
}

}  // namespace

CutShort::CutShort(const std::string& folder) {
    set_last_words("rhexis: the display is gone; what was done is kept: rhexis train --resume " + folder + "\n");
    static const bool registered = std::atexit(say_them) == 0;
    static_cast<void>(registered);
}

CutShort::~CutShort() { set_last_words(""); }

}  // namespace rhexis::station
