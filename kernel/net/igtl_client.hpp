// SPDX-License-Identifier: GPL-3.0-or-later
// Hears over OpenIGTLink where tools are. It connects by itself, and again when the connection is lost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/device_report.hpp"
#include "net/igtl_peer.hpp"

namespace rhexis::igtlink {

/// Of "host" or "host:port"; the host dotted, or localhost; the port is else that of OpenIGTLink.
Result<NetAddress> server_address(std::string_view text);

class Client {
public:
    /// Connects at the first turn(), and asks for tracking data. period_ms: the least between two, 0 or more.
    explicit Client(NetAddress address, int period_ms = 0) : address_(std::move(address)), period_ms_(period_ms) {}

    /// What has come is added to `reports`: tools of TDATA and devices of TRANSFORM as poses (sensor 0), STATUS as a
    /// text (its level is the code) of the device that it names. What comes without a time has come at time_us. Never
    /// waits.
    void turn(double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports);

    [[nodiscard]] bool is_connected() const { return peer_ && peer_->is_open(); }
    /// Why it is not connected, or that no pose comes; empty: all is well.
    [[nodiscard]] std::string trouble(double now_s) const;

private:
    void reach_out(double now_s);
    void ask(double now_s, std::int64_t time_us);
    void take(const Message& message, double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports);

    NetAddress address_;
    int period_ms_;
    std::optional<Peer> peer_;
    bool asked_ = false;
    bool refused_ = false;  ///< the server does not tell tracking data
    double next_try_s_ = 0.0;
    double posed_s_ = 0.0;  ///< when a pose came last, or the connection
    std::string lost_;
};

}  // namespace rhexis::igtlink
