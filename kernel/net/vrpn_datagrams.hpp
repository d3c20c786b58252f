// SPDX-License-Identifier: GPL-3.0-or-later
// The second channel of a VRPN connection: datagrams, for what may be lost because the next one says it anew.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "net/socket.hpp"
#include "net/vrpn_message.hpp"

namespace rhexis::vrpn {

inline constexpr std::size_t most_datagram_bytes = 1472;  ///< what an Ethernet frame holds of a datagram

class Datagrams {
public:
    /// own_host: its end of the connection, where it can be heard by the peer. other_host: the peer's.
    static Result<Datagrams> open(const std::string& own_host, std::string other_host);

    /// "Send to this port of mine."
    [[nodiscard]] Message announcement() const;
    /// The peer's announcement. The port: 1024 to 65535. The host that it names is not followed: what is sent goes to
    /// where the connection does, else a peer could have anybody flooded.
    Status take(const Message& announced);
    /// The peer has announced a port, and the message fits.
    [[nodiscard]] bool carries(const Message& message) const;

    /// With others, in as few datagrams as they fit in; what is left goes with flush(). Only what it carries.
    void send(const Message& message);
    void flush();

    /// Messages of devices that have come from the peer's host. What cannot be read is left out: a datagram may be
    /// anybody's.
    void receive(std::vector<Message>& messages);
    [[nodiscard]] const Socket& socket() const { return socket_; }

private:
    Datagrams(Socket socket, std::string own_host, std::string other_host)
        : socket_(std::move(socket)), own_host_(std::move(own_host)), to_{std::move(other_host), 0} {}

    Socket socket_;
    std::string own_host_;
    NetAddress to_;  ///< port 0: none was announced
    WireBytes unsent_;
    std::uint32_t sequence_ = 0;
};

}  // namespace rhexis::vrpn
