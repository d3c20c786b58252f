// SPDX-License-Identifier: GPL-3.0-or-later
// What each pass of a picture costs.
#pragma once

#include <string>
#include <vector>

namespace rhexis {

/// CPU time of all threads that one pass took. [ms]
struct PassCost {
    std::string pass;
    double cpu_ms = 0.0;
};

/// Does nothing until it is started: for a measured picture the driver is waited for after each pass.
class PassClock {
public:
    void start();
    /// Of what was drawn since the last end, or the start.
    void end(const char* pass);
    std::vector<PassCost> stop();

private:
    bool runs_ = false;
    double since_s_ = 0.0;
    std::vector<PassCost> costs_;
};

}  // namespace rhexis
