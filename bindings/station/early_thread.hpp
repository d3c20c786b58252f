// SPDX-License-Identifier: GPL-3.0-or-later
// A thread that is begun before its work is known: what is begun after it may step back behind it (`step_back`), and
// the threads that a graphics driver begins do so too.
#pragma once

#include <functional>
#include <future>
#include <thread>

namespace rhexis::station {

class EarlyThread {
public:
    EarlyThread();
    /// Waits for its work to end.
    ~EarlyThread();
    EarlyThread(const EarlyThread&) = delete;
    EarlyThread& operator=(const EarlyThread&) = delete;

    /// Once.
    void run(std::function<void()> work);
    void join();

private:
    std::promise<std::function<void()>> work_;
    std::thread thread_;
    bool given_ = false;
};

/// This thread, and those that it begins from now on, run only where nobody else wants to: pictures wait for steps, not
/// steps for pictures.
void step_back();

}  // namespace rhexis::station
