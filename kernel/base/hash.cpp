// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/hash.hpp"

#include <sha2.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <array>
#include <cstdio>
#include <vector>

namespace rhexis {

void StateHash::add_bytes(const void* data, std::size_t size) { hash_ = XXH3_64bits_withSeed(data, size, hash_); }

void StateHash::add(std::uint64_t value) { add_bytes(&value, sizeof value); }

void StateHash::add(double value) {
    const double canonical = value + 0.0;  // -0.0 becomes 0.0
    add_bytes(&canonical, sizeof canonical);
}

void StateHash::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(text.data(), text.size());
}

namespace {

template <typename T>
void add_canonical(StateHash& hash, std::span<const T> values) {
    std::array<T, 512> block;
    std::size_t done = 0;
    while (done < values.size()) {
        const std::size_t count = std::min(block.size(), values.size() - done);
        for (std::size_t i = 0; i < count; ++i) {
            block[i] = values[done + i] + T(0);
        }
        hash.add_bytes(block.data(), count * sizeof(T));
        done += count;
    }
}

}  // namespace

void StateHash::add(std::span<const double> values) { add_canonical(*this, values); }
void StateHash::add(std::span<const float> values) { add_canonical(*this, values); }

std::string sha256_hex(std::string_view text) {
    SHA2_CTX context;
    SHA256Init(&context);
    SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    std::array<char, SHA256_DIGEST_STRING_LENGTH> digest{};
    SHA256End(&context, digest.data());
    return digest.data();
}

std::string hex(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
    return text.data();
}

}  // namespace rhexis
