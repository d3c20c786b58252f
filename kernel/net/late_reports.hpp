// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that came by datagram after a newer one, or twice.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "net/device_report.hpp"

namespace rhexis {

class LateReports {
public:
    /// Whether a newer one of the same device, kind and sensor (button) has come, or one of the same moment. Where for
    /// 0.2 s only older ones have come, the sender's clock was set, and they are not late. now_s: of a clock that only
    /// goes forward.
    bool is_late(const DeviceReport& report, double now_s);
    void clear() { newest_.clear(); }

private:
    struct Newest {
        std::int64_t time_us = 0;
        double came_s = 0.0;
    };
    std::map<std::tuple<std::string, std::size_t, int>, Newest> newest_;
};

}  // namespace rhexis
