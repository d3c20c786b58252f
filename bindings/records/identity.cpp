// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/identity.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <random>

namespace rhexis::records {

std::string new_id() {
    std::random_device chance;
    std::array<std::uint32_t, 4> bits{};
    for (std::uint32_t& word : bits) {
        word = chance();
    }
    bits[1] = (bits[1] & 0xffff0fffu) | 0x00004000u;
    bits[2] = (bits[2] & 0x3fffffffu) | 0x80000000u;
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%08x-%04x-%04x-%04x-%04x%08x", bits[0], bits[1] >> 16, bits[1] & 0xffffu,
                  bits[2] >> 16, bits[2] & 0xffffu, bits[3]);
    return text.data();
}

std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

}  // namespace rhexis::records
