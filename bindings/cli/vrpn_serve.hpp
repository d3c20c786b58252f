// SPDX-License-Identifier: GPL-3.0-or-later
// A recording told as a tracking system would.
#pragma once

#include <string>

#include "net/vrpn_message.hpp"

namespace rhexis::cli {

struct ServeArguments {
    std::string recording;  ///< file, or folder of a run
    std::string address = "127.0.0.1";
    int port = vrpn::port;  ///< 0: any that is free
    double speed = 1.0;
    double from_s = 0.0;  ///< where in the recording it begins
};

/// From when somebody listens to the end of the recording. The exit status.
int serve_recording(const ServeArguments& given);

}  // namespace rhexis::cli
