// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/rng.hpp"

#include <cmath>

#include "base/assert.hpp"

namespace rhexis {
namespace {

std::uint64_t splitmix64(std::uint64_t& x) {
    x += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = x;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

}  // namespace

Rng::Rng(std::uint64_t seed, std::string_view purpose) {
    std::uint64_t mix = seed;
    for (const char c : purpose) {
        mix = splitmix64(mix) ^ static_cast<unsigned char>(c);
    }
    state_.increment = splitmix64(mix) | 1U;
    state_.state = splitmix64(mix) + state_.increment;
    next();
}

std::uint32_t Rng::next() {
    const std::uint64_t old = state_.state;
    state_.state = old * 6364136223846793005ULL + state_.increment;
    const auto xorshifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto rotation = static_cast<std::uint32_t>(old >> 59U);
    return (xorshifted >> rotation) | (xorshifted << ((32U - rotation) & 31U));
}

double Rng::uniform() {
    const std::uint64_t high = next() >> 5U;
    const std::uint64_t low = next() >> 6U;
    return static_cast<double>((high << 26U) | low) * 0x1.0p-53;
}

std::int64_t Rng::integer(std::int64_t low, std::int64_t high) {
    RHEXIS_ASSERT(low <= high);
    const auto span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1U;
    const std::uint64_t bits = (static_cast<std::uint64_t>(next()) << 32U) | next();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + (span == 0 ? bits : bits % span));
}

double Rng::normal() {
    if (state_.has_spare) {
        state_.has_spare = false;
        return state_.spare;
    }
    double u = 0.0;
    double v = 0.0;
    double s = 0.0;
    do {
        u = 2.0 * uniform() - 1.0;
        v = 2.0 * uniform() - 1.0;
        s = u * u + v * v;
    } while (s >= 1.0 || s == 0.0);
    const double factor = std::sqrt(-2.0 * std::log(s) / s);
    state_.spare = v * factor;
    state_.has_spare = true;
    return u * factor;
}

}  // namespace rhexis
