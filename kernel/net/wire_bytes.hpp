// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they go over a network: the most significant byte first.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rhexis {

using WireBytes = std::vector<std::uint8_t>;
using WireSpan = std::span<const std::uint8_t>;

inline void append_u32(std::uint32_t value, WireBytes& out) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

inline void append_i32(std::int32_t value, WireBytes& out) { append_u32(static_cast<std::uint32_t>(value), out); }

inline void append_f64(double value, WireBytes& out) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    append_u32(static_cast<std::uint32_t>(bits >> 32), out);
    append_u32(static_cast<std::uint32_t>(bits), out);
}

inline void append_text(std::string_view text, WireBytes& out) { out.insert(out.end(), text.begin(), text.end()); }

/// Reads one number after the other. Beyond the end all are 0, and failed() says so.
class WireReader {
public:
    explicit WireReader(WireSpan bytes) : rest_(bytes) {}

    std::uint32_t u32() {
        if (rest_.size() < 4) {
            rest_ = {};
            failed_ = true;
            return 0;
        }
        std::uint32_t value = 0;
        for (const std::uint8_t byte : rest_.first(4)) {
            value = value << 8 | byte;
        }
        rest_ = rest_.subspan(4);
        return value;
    }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    double f64() {
        const std::uint64_t high = u32();
        return std::bit_cast<double>(high << 32 | u32());
    }

    [[nodiscard]] WireSpan rest() const { return rest_; }
    [[nodiscard]] bool failed() const { return failed_; }

private:
    WireSpan rest_;
    bool failed_ = false;
};

}  // namespace rhexis
