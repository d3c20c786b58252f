// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/clock.hpp"

namespace rhexis {
namespace {

constexpr double redraw_s = 0.2;
constexpr int bar_width = 24;

std::string bar(double share) {
    std::string text(bar_width, '.');
    std::fill_n(text.begin(), std::lround(share * bar_width), '#');
    return "[" + text + "]";
}

std::string left(double share, double elapsed_s) {
    if (share < 0.02 || elapsed_s < 1.0) {
        return "";
    }
    return "at most " + std::to_string(std::lround(elapsed_s * (1.0 - share) / share)) + " s left";
}

}  // namespace

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)), visible_(!quiet && ::isatty(STDERR_FILENO) == 1), start_s_(wall_seconds()) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (visible_ && drawn_s_ > 0.0) {
        std::fprintf(stderr, "\r\033[K");
        drawn_s_ = 0.0;
    }
}

void Progress::show(double share, const std::string& note) {
    const double now = wall_seconds();
    if (!visible_ || now - drawn_s_ < redraw_s) {
        return;
    }
    drawn_s_ = now;
    share = std::clamp(share, 0.0, 1.0);
    std::fprintf(stderr, "\r\033[K%s %s %s  %s", label_.c_str(), bar(share).c_str(), note.c_str(),
                 left(share, now - start_s_).c_str());
    std::fflush(stderr);
}

}  // namespace rhexis
