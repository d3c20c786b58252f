// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/net_address.hpp"

#include <algorithm>
#include <charconv>

namespace rhexis {

bool is_dotted(std::string_view text) {
    int fields = 1;
    int value = -1;
    for (const char c : text) {
        if (c == '.') {
            if (value < 0) {
                return false;
            }
            ++fields;
            value = -1;
        } else if (c >= '0' && c <= '9') {
            value = 10 * std::max(0, value) + (c - '0');
            if (value > 255) {
                return false;
            }
        } else {
            return false;
        }
    }
    return fields == 4 && value >= 0;
}

std::optional<NetAddress> read_address(std::string_view text, int usual_port) {
    const std::size_t colon = text.find(':');
    const std::string_view host = text.substr(0, colon);
    NetAddress address{host == "localhost" ? "127.0.0.1" : std::string(host), usual_port};
    if (colon != std::string_view::npos) {
        const std::string_view number = text.substr(colon + 1);
        const char* end = number.data() + number.size();
        const auto [stop, fault] = std::from_chars(number.data(), end, address.port);
        if (fault != std::errc() || stop != end) {
            return std::nullopt;
        }
    }
    if (address.port < 1 || address.port > 65535 || !is_dotted(address.host)) {
        return std::nullopt;
    }
    return address;
}

}  // namespace rhexis
