// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/step_back.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace rhexis {

void step_back() {
    constexpr int behind = 10;                                                              // of 19
    static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), behind));  // of one thread
}

}  // namespace rhexis
