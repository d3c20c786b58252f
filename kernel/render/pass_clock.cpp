// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass_clock.hpp"

#include <epoxy/gl.h>

#include <utility>

#include "base/clock.hpp"

namespace rhexis {

void PassClock::start() {
    glFinish();
    runs_ = true;
    costs_.clear();
    since_s_ = process_cpu_seconds();
}

void PassClock::end(const char* pass) {
    if (!runs_) {
        return;
    }
    glFinish();
    const double now_s = process_cpu_seconds();
    costs_.push_back({pass, 1e3 * (now_s - since_s_)});
    since_s_ = now_s;
}

std::vector<PassCost> PassClock::stop() {
    runs_ = false;
    return std::exchange(costs_, {});
}

}  // namespace rhexis
