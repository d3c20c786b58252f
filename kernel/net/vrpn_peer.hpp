// SPDX-License-Identifier: GPL-3.0-or-later
// The other end of a VRPN connection, from the greeting on.
#pragma once

#include <string>
#include <vector>

#include "net/socket.hpp"
#include "net/vrpn_message.hpp"

namespace rhexis::vrpn {

class Peer {
public:
    /// Connected, or about to be. now_s: of a clock that only goes forward.
    Peer(Socket socket, double now_s);

    /// Reads and sends what there is, without waiting. What has come of devices is added to `messages`.
    void turn(double now_s, std::vector<Message>& messages);
    void send(const Message& message);

    /// Both have greeted.
    [[nodiscard]] bool is_open() const { return greeted_ && fault_.empty(); }
    /// Why it can only be dropped; empty: it need not.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] const Names& names() const { return names_; }

private:
    void greet();
    void read_messages(std::vector<Message>& messages);

    Socket socket_;
    double begun_s_;
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
