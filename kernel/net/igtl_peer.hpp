// SPDX-License-Identifier: GPL-3.0-or-later
// The other end of an OpenIGTLink connection.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/igtl_message.hpp"
#include "net/socket.hpp"

namespace rhexis::igtlink {

class Peer {
public:
    /// Connected, or about to be. now_s: of a clock that only goes forward.
    Peer(Socket socket, double now_s);

    /// Reads and sends what there is, without waiting. What has come is added to `messages`.
    void turn(double now_s, std::vector<Message>& messages);
    void send(const WireBytes& message);

    [[nodiscard]] bool is_open() const { return connected_ && fault_.empty(); }
    /// Why it can only be dropped; empty: it need not.
    [[nodiscard]] const std::string& fault() const { return fault_; }

private:
    void connect(double now_s);
    void read_messages(std::vector<Message>& messages);

    Socket socket_;
    double heard_s_;  ///< when something came last; before that, when it began to connect
    bool connected_ = false;
    std::string fault_;
    Stream stream_;
    WireBytes unsent_;
};

}  // namespace rhexis::igtlink
