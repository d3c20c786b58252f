// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/cut_short.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string_view>

namespace rhexis::station {
namespace {

constexpr int bad_input = 2;  ///< as for everything that is missing

/// Of the process, for the system asks nothing else at its end: what is to be said then. Null: nothing.
std::atomic<const std::string*>& last_words() {
    static std::atomic<const std::string*> words = nullptr;
    return words;
}

void say_them() {
    if (const std::string* words = last_words().exchange(nullptr)) {
        static_cast<void>(!::write(STDERR_FILENO, words->data(), words->size()));
        ::_exit(bad_input);
    }
}

}  // namespace

CutShort::CutShort(const std::string& folder) {
    static const bool registered = std::atexit(say_them) == 0;
    static_cast<void>(registered);
    delete last_words().exchange(
        new std::string("rhexis: the display is gone; what was done is kept: rhexis train --resume " + folder + "\n"));
}

CutShort::~CutShort() { delete last_words().exchange(nullptr); }

}  // namespace rhexis::station
