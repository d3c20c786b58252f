// SPDX-License-Identifier: GPL-3.0-or-later
// State hash: XXH3 over the bytes of the state in a fixed order; -0.0 and 0.0 hash alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rhexis {

class StateHash {
public:
    void add(std::uint64_t value);
    void add(double value);
    void add(std::string_view text);
    void add(std::span<const double> values);
    void add(std::span<const float> values);
    void add_bytes(const void* data, std::size_t size);
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0;
};

/// Lower-case hexadecimal SHA-256 of a text, for naming the curriculum that a report belongs to.
std::string sha256_hex(std::string_view text);

/// 16 lower-case hexadecimal digits.
std::string hex(std::uint64_t value);

}  // namespace rhexis
