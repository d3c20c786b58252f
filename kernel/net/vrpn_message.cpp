// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_message.hpp"

#include <algorithm>
#include <charconv>

namespace rhexis::vrpn {
namespace {

constexpr std::string_view same_version = "vrpn: ver. 07.";  ///< all that has to agree
constexpr std::string_view own_greeting = "vrpn: ver. 07.35  0";
constexpr std::size_t log_digit_at = 18;
constexpr std::size_t longest_request = 200;
constexpr std::int64_t us_per_s = 1000000;

std::size_t filled_up(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

Error broken(const std::string& what, const std::string& allowed) { return Error{what, "VRPN", allowed}; }

std::string text_of(WireSpan bytes) { return {bytes.begin(), bytes.end()}; }

/// Of a message that begins there: its length without what fills it up. None: its header has not come.
Result<std::optional<std::size_t>> length_at(WireSpan bytes) {
    if (bytes.size() < header_bytes) {
        return std::optional<std::size_t>();
    }
    const std::size_t length = WireReader(bytes).u32();
    if (length < header_bytes || length > header_bytes + most_payload_bytes) {
        return broken("a message of " + std::to_string(length) + " bytes",
                      std::to_string(header_bytes) + " to " + std::to_string(header_bytes + most_payload_bytes));
    }
    return std::optional(length);
}

/// That lies there whole.
Message message_at(WireSpan bytes, std::size_t length) {
    WireReader reader(bytes.first(header_bytes));
    static_cast<void>(reader.u32());
    Message message;
    message.time_us = us_per_s * reader.u32();
    message.time_us += reader.u32();
    message.sender = reader.i32();
    message.type = reader.i32();
    const WireSpan payload = bytes.subspan(header_bytes, length - header_bytes);
    message.payload.assign(payload.begin(), payload.end());
    return message;
}

/// The name of a description: its length with the 0 at its end, the name, the 0.
Result<std::string> described_name(const WireBytes& payload) {
    WireReader reader(payload);
    const std::int64_t length = reader.i32();
    const WireSpan text = reader.rest();
    const bool fits = !reader.failed() && length >= 2 && length <= static_cast<std::int64_t>(longest_name) + 1 &&
                      length <= static_cast<std::int64_t>(text.size());
    if (!fits || text[static_cast<std::size_t>(length) - 1] != 0) {
        return broken(
            "a name of " + std::to_string(length - 1) + " characters in " + std::to_string(payload.size()) + " bytes",
            "1 to " + std::to_string(longest_name) + " characters, and a 0");
    }
    const std::string name = text_of(text.first(static_cast<std::size_t>(length) - 1));
    if (name.find('\0') != std::string::npos) {
        return broken("a name with a 0 in it", "");
    }
    return name;
}

}  // namespace

WireBytes greeting() {
    WireBytes bytes;
    append_text(own_greeting, bytes);
    bytes.resize(greeting_bytes, 0);
    return bytes;
}

Status check_greeting(WireSpan bytes) {
    const std::string text = text_of(bytes);
    if (text.size() != greeting_bytes || !text.starts_with(same_version)) {
        const std::string shown = text.substr(0, std::min(text.size(), std::string(own_greeting).size() - 3));
        const bool plain = std::all_of(shown.begin(), shown.end(), [](char c) { return c >= ' ' && c <= '~'; });
        return broken("the peer does not speak this version" + (plain ? ": '" + shown + "'" : std::string()),
                      std::string(same_version) + "xx");
    }
    if (text[log_digit_at] < '0' || text[log_digit_at] > '3') {
        return broken("the peer's request for a log cannot be read", "0 to 3");
    }
    return success();
}

void append_message(const Message& message, std::uint32_t sequence, WireBytes& out) {
    RHEXIS_ASSERT(message.payload.size() <= most_payload_bytes);
    RHEXIS_ASSERT(message.time_us >= 0);
    append_u32(static_cast<std::uint32_t>(header_bytes + message.payload.size()), out);
    append_u32(static_cast<std::uint32_t>(message.time_us / us_per_s), out);
    append_u32(static_cast<std::uint32_t>(message.time_us % us_per_s), out);
    append_i32(message.sender, out);
    append_i32(message.type, out);
    append_u32(sequence, out);
    out.insert(out.end(), message.payload.begin(), message.payload.end());
    out.resize(out.size() + filled_up(message.payload.size()) - message.payload.size(), 0);
}

Message description(System of, std::int32_t id, std::string_view name) {
    RHEXIS_ASSERT(!name.empty() && name.size() <= longest_name);
    Message message;
    message.sender = id;
    message.type = static_cast<std::int32_t>(of);
    append_i32(static_cast<std::int32_t>(name.size()) + 1, message.payload);
    append_text(name, message.payload);
    message.payload.push_back(0);
    return message;
}

Result<std::optional<Message>> Stream::next() {
    const WireSpan bytes = WireSpan(waiting_).subspan(taken_);
    Result<std::optional<std::size_t>> length = length_at(bytes);
    if (!length) {
        return length.error();
    }
    const std::size_t whole = length.value() ? filled_up(*length.value()) : 0;
    if (!length.value() || bytes.size() < whole) {
        waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(taken_));
        taken_ = 0;
        return std::optional<Message>();
    }
    Message message = message_at(bytes, *length.value());
    taken_ += whole;
    return std::optional(std::move(message));
}

Result<std::vector<Message>> read_datagram(WireSpan bytes) {
    std::vector<Message> messages;
    while (!bytes.empty()) {
        Result<std::optional<std::size_t>> length = length_at(bytes);
        if (!length) {
            return length.error();
        }
        if (!length.value() || filled_up(*length.value()) > bytes.size()) {
            return broken("a datagram ends within a message", "");
        }
        messages.push_back(message_at(bytes, *length.value()));
        bytes = bytes.subspan(filled_up(*length.value()));
    }
    return messages;
}

Status Names::take(const Message& message) {
    const bool of_sender = message.type == static_cast<std::int32_t>(System::sender_description);
    if (!of_sender && message.type != static_cast<std::int32_t>(System::type_description)) {
        return success();
    }
    if (message.sender < 0 || message.sender >= most_names) {
        return broken("a name of number " + std::to_string(message.sender), "0 to " + std::to_string(most_names - 1));
    }
    Result<std::string> name = described_name(message.payload);
    if (!name) {
        return name.error();
    }
    (of_sender ? senders_ : types_)[message.sender] = std::move(name).value();
    return success();
}

std::string_view Names::name_of(const Table& table, std::int32_t id) {
    const auto found = table.find(id);
    return found == table.end() ? std::string_view() : std::string_view(found->second);
}

WireBytes request_datagram(const NetAddress& own) {
    WireBytes bytes;
    append_text(own.host + " " + std::to_string(own.port), bytes);
    bytes.push_back(0);
    return bytes;
}

Result<NetAddress> read_request(WireSpan bytes, std::string_view from) {
    const std::string text = text_of(bytes.first(std::min(bytes.size(), longest_request)));
    const std::size_t end = text.find('\0');
    const std::size_t space = text.find(' ');
    const std::string allowed = "its own address, a space, a port of 1024 to 65535, a 0";
    if (bytes.size() >= longest_request || end == std::string::npos || space > end ||
        !is_dotted(std::string_view(text).substr(0, space))) {
        return broken("a request to connect that cannot be read", allowed);
    }
    NetAddress asked{text.substr(0, space), 0};
    const char* last = text.data() + end;
    const auto [stop, fault] = std::from_chars(text.data() + space + 1, last, asked.port);
    if (fault != std::errc() || stop != last || asked.port < 1024 || asked.port > 65535) {
        return broken("a request to connect to no port", allowed);
    }
    if (asked.host != from) {
        return broken("a request from " + std::string(from) + " to connect to " + asked.host, allowed);
    }
    return asked;
}

}  // namespace rhexis::vrpn
