// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random numbers, the same on every machine. One stream per purpose, so that adding a consumer
// of chance never shifts the numbers that another one sees.
// Source: [ONeill2014] (PCG-XSH-RR 64/32), seeded through splitmix64 [Steele2014].
#pragma once

#include <cstdint>
#include <string_view>

namespace rhexis {

class Rng {
public:
    /// A stream named by its purpose, e.g. Rng(seed, "tremor").
    explicit Rng(std::uint64_t seed, std::string_view purpose = {});

    std::uint32_t next();
    /// Uniform in [0, 1).
    double uniform();
    /// Uniform integer in [low, high]; low <= high.
    std::int64_t integer(std::int64_t low, std::int64_t high);
    /// Standard normal deviate (polar method; no library transcendental beyond log and sqrt).
    double normal();

    /// State words, for snapshots and hashes.
    struct State {
        std::uint64_t state = 0;
        std::uint64_t increment = 1;
        double spare = 0.0;
        bool has_spare = false;
    };
    [[nodiscard]] const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }

private:
    State state_;
};

}  // namespace rhexis
