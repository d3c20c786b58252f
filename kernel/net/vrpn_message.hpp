// SPDX-License-Identifier: GPL-3.0-or-later
// VRPN's frames [Taylor2001]: the greeting, messages in a stream of bytes or in a datagram, and the names that their
// numbers stand for. Written from the facts of the protocol; what a peer sends is checked here, and nothing of it is
// believed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "net/net_address.hpp"
#include "net/wire_bytes.hpp"

namespace rhexis::vrpn {

inline constexpr int port = 3883;
inline constexpr std::size_t header_bytes = 24;
inline constexpr std::size_t greeting_bytes = 24;
inline constexpr std::size_t most_payload_bytes = 64000;  ///< before it is filled up to eights
inline constexpr std::size_t longest_name = 95;           ///< characters
inline constexpr int most_names = 2000;                   ///< of senders, and of types

/// Messages of the connection itself. What stands where others have the sender is their argument.
enum class System : std::int32_t {
    sender_description = -1,
    type_description = -2,
    udp_description = -3,
    log_description = -4,
    disconnect = -5,
};

struct Message {
    std::int64_t time_us = 0;  ///< by the clock of who sent it, since 1970; 0 to 2^32 s
    std::int32_t sender = 0;
    std::int32_t type = 0;  ///< negative: see System
    WireBytes payload{};
};

/// What both sides send first.
WireBytes greeting();
/// Of a peer: greeting_bytes. Refused is another major version, and a request that is none.
Status check_greeting(WireSpan bytes);

/// As it goes over the wire. sequence: counts the messages of this side on this channel. The payload fits.
void append_message(const Message& message, std::uint32_t sequence, WireBytes& out);

/// "The number of this sender (or type) is id". name: 1 to longest_name characters.
Message description(System of, std::int32_t id, std::string_view name);

/// Messages of one peer, in a stream that comes in pieces of any size.
class Stream {
public:
    void add(WireSpan bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
    /// The next whole message; none: it has not come yet. After an error the peer can only be dropped.
    Result<std::optional<Message>> next();
    /// Bytes that have come and are no whole message yet.
    [[nodiscard]] std::size_t waiting() const { return waiting_.size() - taken_; }

private:
    WireBytes waiting_;
    std::size_t taken_ = 0;
};

/// All messages of a datagram, which holds whole ones only.
Result<std::vector<Message>> read_datagram(WireSpan bytes);

/// What the numbers of a peer's messages mean. Numbers differ from peer to peer.
class Names {
public:
    /// Of a message that is a description; any other changes nothing.
    Status take(const Message& message);
    /// Empty: it was never described.
    [[nodiscard]] std::string_view sender(std::int32_t id) const { return name_of(senders_, id); }
    [[nodiscard]] std::string_view type(std::int32_t id) const { return name_of(types_, id); }

private:
    using Table = std::map<std::int32_t, std::string>;
    static std::string_view name_of(const Table& table, std::int32_t id);
    Table senders_;
    Table types_;
};

/// A client asks a server, by a datagram, to connect to this address of its own.
WireBytes request_datagram(const NetAddress& own);
/// Its port is 1024 to 65535. from: the host that the datagram came from, and the only one that may be asked for: else
/// anybody could have a server connect to anything.
Result<NetAddress> read_request(WireSpan bytes, std::string_view from);

}  // namespace rhexis::vrpn
