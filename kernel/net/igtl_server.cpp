// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/igtl_server.hpp"

#include <algorithm>

namespace rhexis::igtlink {
namespace {

constexpr std::size_t most_guests = 256;
constexpr double ms_per_s = 1000.0;

/// Where tools are.
bool is_told(const Message& message) {
    return std::holds_alternative<Transform>(message.content) || std::holds_alternative<TrackingData>(message.content);
}

}  // namespace

bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= longest_name &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

Result<Server> Server::open(const NetAddress& address, std::string device) {
    if (!is_name(device)) {
        return Error{"a device called '" + device + "'", "OpenIGTLink",
                     "1 to " + std::to_string(longest_name) + " characters, printable ASCII"};
    }
    Result<Socket> listener = Socket::listen_at(address);
    if (!listener) {
        return listener.error();
    }
    return Server(std::move(listener).value(), std::move(device));
}

void Server::turn(double now_s, std::int64_t time_us) {
    let_in(listener_, most_guests, now_s, guests_, notes_);
    std::vector<Message> messages;
    for (Guest& guest : guests_) {
        messages.clear();
        guest.peer.turn(now_s, messages);
        if (guest.peer.is_open() && !guest.introduced) {
            guest.introduced = true;
            guest.peer.send(status_message(time_us));
        }
        for (const Message& message : messages) {
            answer(guest, message, time_us);
        }
    }
    drop_the_gone(guests_, notes_);
}

/// Of what it asks. What it tells is nothing that a server hears.
void Server::answer(Guest& guest, const Message& message, std::int64_t time_us) {
    if (const auto* start = std::get_if<StartTracking>(&message.content)) {
        guest.wish = Wish::tracking_data;
        guest.period_s = start->period_ms / ms_per_s;
        guest.peer.send(bytes_of({device_, time_us, StartReply{true}}));
    } else if (std::holds_alternative<StopTracking>(message.content)) {
        guest.wish = Wish::nothing;
    } else if (std::holds_alternative<StatusRequest>(message.content)) {
        guest.peer.send(status_message(time_us));
    } else if (is_told(message) && !guest.noted) {
        guest.noted = true;
        notes_.push_back("it tells where '" + message.device + "' is: only the server tells, and it is left out");
    }
}

void Server::tell(const std::vector<Tool>& tools, double now_s, std::int64_t time_us) {
    if (tools.empty()) {
        return;
    }
    const WireBytes data = bytes_of({device_, time_us, TrackingData{tools}});
    WireBytes transforms;
    for (const Tool& tool : tools) {
        RHEXIS_ASSERT(is_name(tool.name));
        const WireBytes one = bytes_of({tool.name, time_us, Transform{tool.pose}});
        transforms.insert(transforms.end(), one.begin(), one.end());
    }
    for (Guest& guest : guests_) {
        if (!guest.introduced || !guest.peer.is_open()) {
            continue;
        }
        if (guest.wish == Wish::transforms) {
            guest.peer.send(transforms);
        } else if (guest.wish == Wish::tracking_data && now_s - guest.told_s >= guest.period_s) {
            guest.told_s = now_s;
            guest.peer.send(data);
        }
    }
}

void Server::tell_status(const DeviceStatus& status, std::int64_t time_us) {
    if (status == status_) {
        return;
    }
    status_ = status;
    const WireBytes message = status_message(time_us);
    for (Guest& guest : guests_) {
        if (guest.introduced && guest.peer.is_open()) {
            guest.peer.send(message);
        }
    }
}

WireBytes Server::status_message(std::int64_t time_us) const { return bytes_of({device_, time_us, status_}); }

std::size_t Server::peer_count() const {
    return static_cast<std::size_t>(
        std::count_if(guests_.begin(), guests_.end(), [](const Guest& guest) { return guest.introduced; }));
}

}  // namespace rhexis::igtlink
