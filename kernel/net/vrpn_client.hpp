// SPDX-License-Identifier: GPL-3.0-or-later
// Hears what devices of a VRPN server do. It connects by itself, and again when the connection is lost. Where datagrams
// are wanted and none comes through, as behind a wall that drops them, it connects anew without wanting them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/late_reports.hpp"
#include "net/vrpn_peer.hpp"
#include "net/vrpn_report.hpp"

namespace rhexis::vrpn {

/// Where a server is, and how to come to it.
struct ServerPlace {
    NetAddress address{"127.0.0.1", port};
    bool asks_by_datagram = true;  ///< and wants poses by datagram; else it connects by TCP itself, and all comes so
};

/// Of "host", "host:port" or "tcp://host:port"; the host dotted, or localhost.
Result<ServerPlace> server_place(std::string_view text);

class Client {
public:
    /// devices: those that it pings and listens to; optional: those that it listens to, where there are such. Connects
    /// at the first turn().
    Client(ServerPlace place, std::vector<std::string> devices, const std::vector<std::string>& optional = {});

    /// What has come is added to `reports`. Never waits.
    void turn(double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports);
    /// Waits until something has come for the next turn(), no longer than this [ms].
    void wait(int longest_ms) const;

    [[nodiscard]] bool is_connected() const { return peer_ && peer_->is_open(); }
    /// Why it is not connected, or what a device does not answer; empty: all is well.
    [[nodiscard]] std::string trouble(double now_s) const;

private:
    void reach_out(double now_s);
    void ping(double now_s, std::int64_t time_us);
    void take(const Message& message, double now_s, std::vector<DeviceReport>& reports);
    void take_datagram(const Message& message, double now_s, std::vector<DeviceReport>& reports);
    void see_whether_lost(double now_s);
    [[nodiscard]] bool is_forsaken(double now_s) const;
    [[nodiscard]] bool is_walled(double now_s) const;
    void lose(const std::string& why, double now_s);

    ServerPlace place_;
    std::vector<std::string> devices_;  ///< the optional ones last
    std::vector<bool> answered_;        ///< of those that are not optional
    std::optional<Socket> datagrams_;
    std::optional<Socket> listener_;  ///< for the server that is asked to connect
    std::optional<Peer> peer_;
    LateReports late_;
    bool datagrams_pass_ = true;     ///< until it was found that they do not
    bool datagram_or_pose_ = false;  ///< one of them has come over this connection
    bool introduced_ = false;
    double next_try_s_ = 0.0;
    double next_ping_s_ = 0.0;
    double open_since_s_ = 0.0;
    double last_heard_s_ = 0.0;
    std::string lost_;
};

}  // namespace rhexis::vrpn
