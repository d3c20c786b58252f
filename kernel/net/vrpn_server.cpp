// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_server.hpp"

#include <algorithm>
#include <array>

#include "net/vrpn_report.hpp"

namespace rhexis::vrpn {
namespace {

constexpr std::size_t most_guests = 256;
constexpr int most_datagrams = 64;  ///< that are read at one turn

/// In the order of their numbers here.
constexpr std::array types{ping_type,     pong_type,   text_type,    pose_type,
                           velocity_type, button_type, buttons_type, analog_type};

std::int32_t number_of(std::string_view type) {
    const auto* found = std::find(types.begin(), types.end(), type);
    RHEXIS_ASSERT(found != types.end());
    return static_cast<std::int32_t>(found - types.begin());
}

/// A pose that is lost is followed by another; a button or pedal that is lost would stay where it was.
bool is_lossy(std::int32_t type) { return type == number_of(pose_type) || type == number_of(velocity_type); }

/// Whether a type is of what a device does: only a server tells that.
bool is_told(std::string_view type) {
    return type != ping_type && type != pong_type && type != text_type &&
           std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

Result<Server> Server::open(const NetAddress& address, std::vector<std::string> devices) {
    for (const std::string& device : devices) {
        if (device.empty() || device.size() > longest_name) {
            return Error{"a device called '" + device + "'", "VRPN",
                         "1 to " + std::to_string(longest_name) + " characters"};
        }
    }
    Result<Socket> listener = Socket::listen_at(address);
    if (!listener) {
        return listener.error();
    }
    Result<Socket> datagrams = Socket::datagrams_at({address.host, listener.value().port()});
    if (!datagrams) {
        return datagrams.error();
    }
    return Server(std::move(listener).value(), std::move(datagrams).value(), std::move(devices));
}

Server::Server(Socket listener, Socket datagrams, std::vector<std::string> devices)
    : listener_(std::move(listener)), datagrams_(std::move(datagrams)), devices_(std::move(devices)) {}

void Server::turn(double now_s, std::int64_t time_us) {
    let_in(now_s);
    std::vector<Message> messages;
    for (Guest& guest : guests_) {
        messages.clear();
        guest.peer.turn(now_s, messages);
        if (guest.peer.is_open() && !guest.introduced) {
            guest.introduced = true;
            introduce(guest.peer);
        }
        guest.peer.receive_datagrams(messages);
        for (const Message& message : messages) {
            answer(guest, message, time_us);
        }
    }
    drop_the_gone(guests_, notes_);
}

void Server::let_in(double now_s) {
    rhexis::let_in(listener_, most_guests, now_s, guests_, notes_);
    for (int i = 0; i < most_datagrams; ++i) {
        const std::optional<Socket::Datagram> datagram = datagrams_.receive();
        if (!datagram) {
            return;
        }
        const Result<NetAddress> asked = read_request(datagram->bytes, datagram->from.host);
        if (!asked) {
            notes_.push_back(asked.error().text());
            continue;
        }
        const bool again = std::any_of(guests_.begin(), guests_.end(),
                                       [&](const Guest& guest) { return guest.asked_from == asked.value(); });
        if (again || guests_.size() >= most_guests) {
            continue;
        }
        if (Result<Socket> socket = Socket::connect_to(asked.value())) {
            guests_.push_back({Peer(std::move(socket).value(), now_s, true), false, asked.value()});
        }
    }
}

/// What its numbers mean, and what is so now.
void Server::introduce(Peer& peer) const {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        peer.send(description(System::sender_description, static_cast<std::int32_t>(i), devices_[i]));
    }
    for (std::size_t i = 0; i < types.size(); ++i) {
        peer.send(description(System::type_description, static_cast<std::int32_t>(i), types[i]));
    }
    for (const auto& [of, message] : kept_) {
        peer.send(message);
    }
}

/// A ping, by the device that it is for. What else comes is nothing that a server is told; whoever takes this for
/// another kind of server is noted, once.
void Server::answer(Guest& guest, const Message& message, std::int64_t time_us) {
    const std::string_view type = guest.peer.names().type(message.type);
    const auto device = std::find(devices_.begin(), devices_.end(), guest.peer.names().sender(message.sender));
    if (is_told(type) && !guest.noted) {
        guest.noted = true;
        notes_.push_back("it tells '" + std::string(type) + "'" +
                         (device == devices_.end() ? "" : " of '" + *device + "'") +
                         ": only the server tells, and it is left out");
    }
    if (type != ping_type || device == devices_.end()) {
        return;
    }
    const auto number = static_cast<std::int32_t>(device - devices_.begin());
    const Message pong = report(*device, pong_type, {}, time_us);
    guest.peer.send(pong);
    if (guest.peer.wants_datagrams()) {
        guest.peer.send_lossy(pong);  // shows that datagrams come through where there is no pose to tell yet
    }
    for (const auto& [of, kept] : kept_) {
        if (of.first == number) {
            guest.peer.send(kept);
        }
    }
}

Message Server::report(std::string_view device, std::string_view type, const WireBytes& payload,
                       std::int64_t time_us) const {
    const auto found = std::find(devices_.begin(), devices_.end(), device);
    RHEXIS_ASSERT(found != devices_.end());
    return {time_us, static_cast<std::int32_t>(found - devices_.begin()), number_of(type), payload};
}

void Server::to_all(const Message& message) {
    for (Guest& guest : guests_) {
        if (guest.introduced && guest.peer.is_open()) {
            is_lossy(message.type) ? guest.peer.send_lossy(message) : guest.peer.send(message);
        }
    }
}

void Server::tell(std::string_view device, std::string_view type, const WireBytes& payload, std::int64_t time_us) {
    to_all(report(device, type, payload, time_us));
}

void Server::keep(std::string_view device, std::string_view type, const WireBytes& payload, std::int64_t time_us) {
    const Message message = report(device, type, payload, time_us);
    kept_[{message.sender, message.type}] = message;
    to_all(message);
}

std::size_t Server::peer_count() const {
    return static_cast<std::size_t>(
        std::count_if(guests_.begin(), guests_.end(), [](const Guest& guest) { return guest.peer.is_open(); }));
}

}  // namespace rhexis::vrpn
