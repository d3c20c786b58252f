// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/igtl_peer.hpp"

#include <utility>

namespace rhexis::igtlink {
namespace {

constexpr double patience_s = 3.0;             ///< with who does not answer, or stops within a message
constexpr std::size_t most_unsent = 1U << 20;  ///< bytes that a peer which does not read leaves lying

}  // namespace

Peer::Peer(Socket socket, double now_s) : socket_(std::move(socket)), heard_s_(now_s) {}

void Peer::turn(double now_s, std::vector<Message>& messages) {
    if (fault_.empty() && !connected_) {
        connect(now_s);
    }
    if (!is_open()) {
        return;
    }
    WireBytes come;
    const bool open = socket_.write(unsent_) && socket_.read(come);
    heard_s_ = come.empty() ? heard_s_ : now_s;
    stream_.add(come);
    read_messages(messages);
    if (!fault_.empty()) {
        return;
    }
    if (!open) {
        fault_ = "it has closed the connection";
    } else if (stream_.waiting() > 0 && now_s - heard_s_ > patience_s) {
        fault_ = "it stopped within a message";
    }
}

void Peer::connect(double now_s) {
    const std::optional<bool> connected = socket_.is_connected();
    connected_ = connected.value_or(false);
    if (connected == false || (!connected && now_s - heard_s_ > patience_s)) {
        fault_ = "nobody answers";
    }
}

void Peer::read_messages(std::vector<Message>& messages) {
    while (true) {
        Result<std::optional<Message>> next = stream_.next();
        if (!next) {
            fault_ = next.error().text();
            return;
        }
        if (!next.value()) {
            return;
        }
        messages.push_back(*std::move(next).value());
    }
}

void Peer::send(const WireBytes& message) {
    unsent_.insert(unsent_.end(), message.begin(), message.end());
    if (unsent_.size() > most_unsent) {
        fault_ = "it does not read what it is sent";
    }
}

}  // namespace rhexis::igtlink
