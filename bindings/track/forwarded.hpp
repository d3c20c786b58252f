// SPDX-License-Identifier: GPL-3.0-or-later
// What no camera sees: jaws, buttons, the foot and what is asked of the staff, heard from another VRPN server and told
// by ours under the same names.
#pragma once

#include <string>
#include <vector>

#include "net/vrpn_client.hpp"
#include "net/vrpn_server.hpp"

namespace rhexis::tracking {

class Forwarded {
public:
    /// server: "ADDRESS", "ADDRESS:PORT" or "tcp://ADDRESS"; instruments: devices that may be there beside the pedal
    /// and the staff. Connects at the first turn().
    static Result<Forwarded> open(const std::string& server, std::vector<std::string> instruments);
    /// Names that are told.
    [[nodiscard]] const std::vector<std::string>& devices() const { return devices_; }

    /// Tells what has come, stamped with when it came: its sender's clock is another than that of poses. Poses are left
    /// out. Never waits.
    void turn(double now_s, std::int64_t time_us, vrpn::Server& to);
    /// Why it is not connected, or that it has no pedal; empty: all is well.
    [[nodiscard]] std::string trouble(double now_s) const { return client_.trouble(now_s); }

private:
    Forwarded(vrpn::Client client, std::vector<std::string> devices)
        : client_(std::move(client)), devices_(std::move(devices)) {}

    vrpn::Client client_;
    std::vector<std::string> devices_;
    std::vector<DeviceReport> reports_;
};

}  // namespace rhexis::tracking
