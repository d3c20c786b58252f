// SPDX-License-Identifier: GPL-3.0-or-later
// What rhexis vrpn and rhexis igtl have in common: reports printed a line each, and a recording told in its own time.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "net/device_report.hpp"
#include "session/recording.hpp"

namespace rhexis::cli {

struct ListenArguments {
    std::string server;
    double seconds = 0.0;  ///< 0: until it is ended
    bool json = false;
};

/// A client of any protocol, as vrpn::Client and igtlink::Client have these.
struct Listener {
    std::function<void(double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports)> turn;
    std::function<std::string(double now_s)> trouble;
};

/// The options --seconds and --json.
void add_listen_options(CLI::App& command, ListenArguments& given);
/// Prints what is heard, and on stderr what troubles it after the first second. Gives the status of the command:
/// found_failures when nothing was heard.
int listen(const ListenArguments& given, const Listener& listener);

struct ServeArguments {
    std::string recording;
    std::string address = "127.0.0.1";
    int port = 0;
    double speed = 1.0;
    double from_s = 0.0;  ///< where in the recording it begins
};

struct SeenStep {
    std::vector<std::optional<DeviceSample>> instruments;  ///< none: it is never used
    std::vector<std::string> asked{};                      ///< of the staff (station/asked.hpp)
};

/// A server of any protocol.
struct Teller {
    std::vector<std::string> devices;  ///< that it tells of, for who reads the first line
    int port = 0;                      ///< where it is heard
    std::function<std::size_t()> peer_count;
    std::function<void(double now_s, std::int64_t time_us)> turn;
    std::function<std::vector<std::string>()> take_notes;
    /// time_us: of the moment that the step is of, not of when it is told.
    std::function<void(const SeenStep& step, double now_s, std::int64_t time_us)> tell;
};

/// The argument of the recording, and --address, --port (else given.port), --speed and --from.
void add_serve_options(CLI::App& command, ServeArguments& given);
/// Tells the steps of a recording as cameras would see them, from when somebody listens. The status of the command.
int serve(const ServeArguments& given, const Recording& recording, const Teller& teller);

}  // namespace rhexis::cli
