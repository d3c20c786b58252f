// SPDX-License-Identifier: GPL-3.0-or-later
// Log lines collected by their session and shown by whoever runs it. There is no global log.
#pragma once

#include <string>
#include <vector>

namespace rhexis {

enum class LogLevel { info, warning, error };

struct LogLine {
    LogLevel level = LogLevel::info;
    double time_s = 0.0;  ///< simulated time
    std::string text;
};

using Log = std::vector<LogLine>;

}  // namespace rhexis
