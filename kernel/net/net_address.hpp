// SPDX-License-Identifier: GPL-3.0-or-later
// Where a socket is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rhexis {

/// Of an IPv4 socket. port: 0, any that is free.
struct NetAddress {
    std::string host = "127.0.0.1";  ///< dotted
    int port = 0;
    bool operator==(const NetAddress&) const = default;
};

/// Four numbers of 0 to 255 with dots.
bool is_dotted(std::string_view text);

/// Of "host" or "host:port", the host dotted or localhost, the port 1 to 65535. Nothing: the text is neither.
std::optional<NetAddress> read_address(std::string_view text, int usual_port);

}  // namespace rhexis
