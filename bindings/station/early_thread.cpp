// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/early_thread.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <utility>

namespace rhexis::station {

EarlyThread::EarlyThread()
    : thread_([work = work_.get_future()]() mutable {
          if (const std::function<void()> given = work.get()) {
              given();
          }
      }) {}

EarlyThread::~EarlyThread() {
    if (!given_) {
        work_.set_value(nullptr);
    }
    join();
}

void EarlyThread::run(std::function<void()> work) {
    given_ = true;
    work_.set_value(std::move(work));
}

void EarlyThread::join() {
    if (thread_.joinable()) {
        thread_.join();
    }
}

void step_back() {
    constexpr int behind = 10;  // of 19
    // of a thread, on Linux; where it is refused pictures and steps share as they did
    static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), behind));
}

}  // namespace rhexis::station
