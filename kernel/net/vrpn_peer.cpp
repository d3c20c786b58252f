// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_peer.hpp"

#include <algorithm>
#include <utility>

namespace rhexis::vrpn {
namespace {

constexpr double greeting_s = 3.0;             ///< within which a peer has greeted
constexpr std::size_t most_unsent = 1U << 20;  ///< bytes that a peer which does not read leaves lying

}  // namespace

Peer::Peer(Socket socket, double now_s, bool announces)
    : socket_(std::move(socket)), begun_s_(now_s), announces_(announces), unsent_(greeting()) {}

void Peer::turn(double now_s, std::vector<Message>& messages) {
    if (!fault_.empty()) {
        return;
    }
    if (!greeted_ && now_s - begun_s_ > greeting_s) {
        fault_ = "it did not greet within " + std::to_string(static_cast<int>(greeting_s)) + " s";
        return;
    }
    if (!connected_) {
        const std::optional<bool> connected = socket_.is_connected();
        if (!connected) {
            return;
        }
        connected_ = *connected;
    }
    if (datagrams_) {
        datagrams_->flush();
    }
    WireBytes come;
    const bool open = connected_ && socket_.write(unsent_) && socket_.read(come);
    const std::size_t of_greeting = std::min(greeting_bytes - greeting_.size(), come.size());
    greeting_.insert(greeting_.end(), come.begin(), come.begin() + static_cast<std::ptrdiff_t>(of_greeting));
    greet();
    stream_.add(WireSpan(come).subspan(of_greeting));
    if (greeted_) {
        read_messages(messages);
    }
    if (fault_.empty() && !open) {
        fault_ = connected_ ? "it has closed the connection" : "nobody answers";
    }
}

void Peer::greet() {
    if (greeted_ || greeting_.size() < greeting_bytes) {
        return;
    }
    const Status understood = check_greeting(greeting_);
    greeted_ = understood.ok();
    fault_ = understood ? "" : understood.error().text();
    if (greeted_ && announces_) {
        announce();
    }
}

/// Without a port of its own, which no system refuses for long, all goes by TCP.
void Peer::announce() {
    Result<Datagrams> opened = Datagrams::open(socket_.own_host(), socket_.other_host());
    if (opened) {
        datagrams_.emplace(std::move(opened).value());
        send(datagrams_->announcement());
    }
}

/// Who wants datagrams gets them, also where no port of our own was announced.
Status Peer::take_announcement(const Message& message) {
    if (!datagrams_) {
        Result<Datagrams> opened = Datagrams::open(socket_.own_host(), socket_.other_host());
        if (!opened) {
            return success();
        }
        datagrams_.emplace(std::move(opened).value());
    }
    const Status taken = datagrams_->take(message);
    wants_datagrams_ = taken.ok();
    return taken;
}

void Peer::read_messages(std::vector<Message>& messages) {
    while (fault_.empty()) {
        Result<std::optional<Message>> next = stream_.next();
        if (!next) {
            fault_ = next.error().text();
        } else if (!next.value()) {
            return;
        } else if (const Status taken = names_.take(*next.value()); !taken) {
            fault_ = taken.error().text();
        } else if (next.value()->type == static_cast<std::int32_t>(System::udp_description)) {
            const Status announced = take_announcement(*next.value());
            fault_ = announced ? "" : announced.error().text();
        } else if (next.value()->type >= 0) {
            messages.push_back(*std::move(next).value());
        }
    }
}

void Peer::send(const Message& message) {
    append_message(message, sequence_++, unsent_);
    if (unsent_.size() > most_unsent) {
        fault_ = "it does not read what it is sent";
    }
}

void Peer::send_lossy(const Message& message) {
    if (datagrams_ && datagrams_->carries(message)) {
        datagrams_->send(message);
    } else {
        send(message);
    }
}

void Peer::add_sockets(std::vector<const Socket*>& sockets) const {
    sockets.push_back(&socket_);
    if (datagrams_) {
        sockets.push_back(&datagrams_->socket());
    }
}

void Peer::receive_datagrams(std::vector<Message>& messages) {
    if (datagrams_ && is_open()) {
        datagrams_->receive(messages);
    }
}

}  // namespace rhexis::vrpn
