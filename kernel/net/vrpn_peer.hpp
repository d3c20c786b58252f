// SPDX-License-Identifier: GPL-3.0-or-later
// The other end of a VRPN connection, from the greeting on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/socket.hpp"
#include "net/vrpn_datagrams.hpp"
#include "net/vrpn_message.hpp"

namespace rhexis::vrpn {

class Peer {
public:
    /// Connected, or about to be. now_s: of a clock that only goes forward. announces: a port for datagrams, at once;
    /// else it has one only where the peer announces its own.
    Peer(Socket socket, double now_s, bool announces = false);

    /// Reads and sends what there is, without waiting. What has come of devices is added to `messages`.
    void turn(double now_s, std::vector<Message>& messages);
    void send(const Message& message);
    /// What the next one says anew: by datagram, where the peer wants such.
    void send_lossy(const Message& message);
    /// What has come of devices by datagram is added to `messages`.
    void receive_datagrams(std::vector<Message>& messages);
    /// Those by which something may come.
    void add_sockets(std::vector<const Socket*>& sockets) const;
    /// The peer has announced a port for datagrams.
    [[nodiscard]] bool wants_datagrams() const { return wants_datagrams_; }

    /// Both have greeted.
    [[nodiscard]] bool is_open() const { return greeted_ && fault_.empty(); }
    /// Why it can only be dropped; empty: it need not.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] const Names& names() const { return names_; }

private:
    void greet();
    void announce();
    Status take_announcement(const Message& message);
    void read_messages(std::vector<Message>& messages);

    Socket socket_;
    std::optional<Datagrams> datagrams_;
    double begun_s_;
    bool announces_;
    bool wants_datagrams_ = false;
    bool connected_ = false;
    bool greeted_ = false;
    std::string fault_;
    WireBytes greeting_;  ///< as far as it has come
    Stream stream_;
    Names names_;
    WireBytes unsent_;
    std::uint32_t sequence_ = 0;
};

}  // namespace rhexis::vrpn
