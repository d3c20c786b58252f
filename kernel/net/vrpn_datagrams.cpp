// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_datagrams.hpp"

#include <utility>

namespace rhexis::vrpn {
namespace {

constexpr int most_received = 256;  ///< datagrams that are read at one turn: others want theirs too
constexpr int least_port = 1024;
constexpr int last_port = 65535;

std::size_t framed_bytes(const Message& message) { return header_bytes + (message.payload.size() + 7) / 8 * 8; }

}  // namespace

Result<Datagrams> Datagrams::open(const std::string& own_host, std::string other_host) {
    Result<Socket> socket = Socket::datagrams_at({own_host, 0});
    if (!socket) {
        return socket.error();
    }
    return Datagrams(std::move(socket).value(), own_host, std::move(other_host));
}

Message Datagrams::announcement() const {
    Message message;
    message.sender = socket_.port();
    message.type = static_cast<std::int32_t>(System::udp_description);
    append_text(own_host_, message.payload);
    message.payload.push_back(0);
    return message;
}

Status Datagrams::take(const Message& announced) {
    if (announced.sender < least_port || announced.sender > last_port) {
        return Error{"datagrams to port " + std::to_string(announced.sender), "VRPN",
                     std::to_string(least_port) + " to " + std::to_string(last_port)};
    }
    to_.port = announced.sender;
    return success();
}

bool Datagrams::carries(const Message& message) const {
    return to_.port != 0 && framed_bytes(message) <= most_datagram_bytes;
}

void Datagrams::send(const Message& message) {
    RHEXIS_ASSERT(carries(message));
    if (unsent_.size() + framed_bytes(message) > most_datagram_bytes) {
        flush();
    }
    append_message(message, sequence_++, unsent_);
}

void Datagrams::flush() {
    if (!unsent_.empty()) {
        socket_.send_to(to_, unsent_);
        unsent_.clear();
    }
}

void Datagrams::receive(std::vector<Message>& messages) {
    for (int i = 0; i < most_received; ++i) {
        const std::optional<Socket::Datagram> datagram = socket_.receive();
        if (!datagram) {
            return;
        }
        if (datagram->from.host != to_.host) {
            continue;
        }
        Result<std::vector<Message>> read = read_datagram(datagram->bytes);
        if (!read) {
            continue;
        }
        for (Message& message : read.value()) {
            if (message.type >= 0) {
                messages.push_back(std::move(message));
            }
        }
    }
}

}  // namespace rhexis::vrpn
