// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_client.hpp"

#include <algorithm>
#include <utility>

namespace rhexis::vrpn {
namespace {

constexpr double retry_s = 2.0;
constexpr double ping_every_s = 1.0;
constexpr double patience_s = 3.0;  ///< with a device that does not answer
constexpr double silence_s = 5.0;   ///< in spite of pings, from devices that did answer: nobody is there any more

/// A payload as a report, of a type that is one.
template <typename What>
Status put(Result<What> read, DeviceReport& report) {
    if (!read) {
        return read.error();
    }
    report.what = std::move(read).value();
    return success();
}

/// False: the type is none that is heard.
Result<bool> read_report(std::string_view type, WireSpan payload, DeviceReport& report) {
    Status read = success();
    if (type == pose_type) {
        read = put(read_pose(payload), report);
    } else if (type == velocity_type) {
        read = put(read_velocity(payload), report);
    } else if (type == button_type) {
        read = put(read_button(payload), report);
    } else if (type == buttons_type) {
        read = put(read_buttons(payload), report);
    } else if (type == analog_type) {
        read = put(read_analog(payload), report);
    } else if (type == text_type) {
        read = put(read_text(payload), report);
    } else {
        return false;
    }
    return read ? Result<bool>(true) : Result<bool>(read.error());
}

}  // namespace

Result<ServerPlace> server_place(std::string_view text) {
    ServerPlace place;
    std::string_view rest = text;
    constexpr std::string_view tcp = "tcp://";
    if (rest.starts_with(tcp)) {
        place.asks_by_datagram = false;
        rest.remove_prefix(tcp.size());
    }
    std::optional<NetAddress> address = read_address(rest, port);
    if (!address) {
        return Error{"no VRPN server: '" + std::string(text) + "'", "",
                     "ADDRESS, ADDRESS:PORT or tcp://ADDRESS:PORT, the address dotted or localhost"};
    }
    place.address = *std::move(address);
    return place;
}

Client::Client(ServerPlace place, std::vector<std::string> devices, const std::vector<std::string>& optional)
    : place_(std::move(place)), devices_(std::move(devices)), answered_(devices_.size(), false) {
    devices_.insert(devices_.end(), optional.begin(), optional.end());
}

void Client::wait(int longest_ms) const {
    std::vector<const Socket*> sockets;
    if (peer_) {
        peer_->add_sockets(sockets);
    } else if (listener_) {
        sockets.push_back(&*listener_);
    }
    Socket::wait_for(sockets, longest_ms);
}

void Client::turn(double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports) {
    if (!peer_) {
        reach_out(now_s);
    }
    if (!peer_) {
        return;
    }
    std::vector<Message> messages;
    std::vector<Message> datagrams;
    peer_->turn(now_s, messages);
    peer_->receive_datagrams(datagrams);
    last_heard_s_ = messages.empty() && datagrams.empty() ? last_heard_s_ : now_s;
    if (peer_->is_open()) {
        ping(now_s, time_us);
    }
    for (const Message& message : messages) {
        if (peer_) {
            take(message, now_s, reports);
        }
    }
    for (const Message& message : datagrams) {
        if (peer_) {
            take_datagram(message, now_s, reports);
        }
    }
    see_whether_lost(now_s);
}

void Client::see_whether_lost(double now_s) {
    if (peer_ && !peer_->fault().empty()) {
        lose(peer_->fault(), now_s);
    } else if (peer_ && is_forsaken(now_s)) {
        lose("nothing has come for " + std::to_string(static_cast<int>(silence_s)) + " s", now_s);
    } else if (peer_ && is_walled(now_s)) {
        datagrams_pass_ = false;
        lose("no pose and no datagram has come for " + std::to_string(static_cast<int>(patience_s)) +
                 " s: all by TCP from now on, as tcp://" + place_.address.host + " has it from the start",
             now_s);
        next_try_s_ = now_s;
    }
}

/// The server wants to send datagrams, and none comes through.
bool Client::is_walled(double now_s) const {
    return datagrams_pass_ && peer_->wants_datagrams() && !datagram_or_pose_ && introduced_ &&
           now_s - open_since_s_ > patience_s;
}

/// A cable that was drawn, or a computer that was switched off, closes no connection.
bool Client::is_forsaken(double now_s) const {
    return now_s - last_heard_s_ > silence_s && std::find(answered_.begin(), answered_.end(), true) != answered_.end();
}

/// Connects, or asks to be connected to and waits for it.
void Client::reach_out(double now_s) {
    if (listener_) {
        while (std::optional<Socket> come = listener_->accept()) {
            if (come->other_host() == place_.address.host) {  // nobody else was asked
                peer_.emplace(std::move(*come), now_s, datagrams_pass_);
                return;
            }
        }
    }
    if (now_s < next_try_s_) {
        return;
    }
    next_try_s_ = now_s + retry_s;
    if (!place_.asks_by_datagram) {
        Result<Socket> socket = Socket::connect_to(place_.address);
        if (socket) {
            peer_.emplace(std::move(socket).value(), now_s);
        } else {
            lost_ = socket.error().text();
        }
        return;
    }
    const std::string own = place_.address.host.starts_with("127.") ? "127.0.0.1" : "0.0.0.0";
    if (!listener_) {
        Result<Socket> listener = Socket::listen_at({own, 0});
        Result<Socket> datagrams = Socket::datagrams_at({own, 0});
        if (!listener || !datagrams) {
            lost_ = (listener ? datagrams : listener).error().text();
            return;
        }
        listener_.emplace(std::move(listener).value());
        datagrams_.emplace(std::move(datagrams).value());
    }
    const std::string seen = Socket::address_towards(place_.address);
    datagrams_->send_to(place_.address, request_datagram({seen, listener_->port()}));
}

/// Each device once a second, until it answers, and again while nothing comes.
void Client::ping(double now_s, std::int64_t time_us) {
    if (!introduced_) {
        introduced_ = true;
        open_since_s_ = now_s;
        next_ping_s_ = now_s;
        lost_.clear();
        for (std::size_t i = 0; i < devices_.size(); ++i) {
            peer_->send(description(System::sender_description, static_cast<std::int32_t>(i), devices_[i]));
        }
        peer_->send(description(System::type_description, 0, ping_type));
    }
    if (now_s < next_ping_s_) {
        return;
    }
    next_ping_s_ = now_s + ping_every_s;
    const bool silent = now_s - last_heard_s_ > ping_every_s;
    for (std::size_t i = 0; i < answered_.size(); ++i) {
        if (!answered_[i] || silent) {
            peer_->send({time_us, static_cast<std::int32_t>(i), 0, {}});
        }
    }
}

void Client::take(const Message& message, double now_s, std::vector<DeviceReport>& reports) {
    const std::string_view type = peer_->names().type(message.type);
    const auto device = std::find(devices_.begin(), devices_.end(), peer_->names().sender(message.sender));
    if (device == devices_.end()) {
        return;
    }
    if (type == pong_type) {
        const auto which = static_cast<std::size_t>(device - devices_.begin());
        if (which < answered_.size()) {
            answered_[which] = true;
        }
        return;
    }
    DeviceReport report{*device, message.time_us};
    const Result<bool> read = read_report(type, message.payload, report);
    if (!read) {
        lose(read.error().text(), now_s);
    } else if (read.value()) {
        datagram_or_pose_ = datagram_or_pose_ || std::holds_alternative<PoseReport>(report.what);
        reports.push_back(std::move(report));
    }
}

/// Lost, doubled, out of order, before what its numbers mean was told, or anybody's: what makes no sense is left out.
void Client::take_datagram(const Message& message, double now_s, std::vector<DeviceReport>& reports) {
    datagram_or_pose_ = true;
    const auto device = std::find(devices_.begin(), devices_.end(), peer_->names().sender(message.sender));
    if (device == devices_.end()) {
        return;
    }
    DeviceReport report{*device, message.time_us};
    report.by_datagram = true;
    const Result<bool> read = read_report(peer_->names().type(message.type), message.payload, report);
    if (read && read.value() && !late_.is_late(report, now_s)) {
        reports.push_back(std::move(report));
    }
}

void Client::lose(const std::string& why, double now_s) {
    lost_ = why;
    next_try_s_ = now_s + retry_s;
    peer_.reset();
    listener_.reset();  // what the server still has of it is not taken for a new request
    datagrams_.reset();
    late_.clear();
    datagram_or_pose_ = false;
    introduced_ = false;
    answered_.assign(answered_.size(), false);
}

std::string Client::trouble(double now_s) const {
    if (!is_connected()) {
        return lost_.empty() ? "no VRPN server has answered yet" : lost_;
    }
    for (std::size_t i = 0; i < answered_.size(); ++i) {
        if (!answered_[i] && introduced_ && now_s - open_since_s_ > patience_s) {
            return "the server has no '" + devices_[i] + "', or it does not answer";
        }
    }
    return "";
}

}  // namespace rhexis::vrpn
