// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/net_address.hpp"

#include <algorithm>

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

}  // namespace rhexis
