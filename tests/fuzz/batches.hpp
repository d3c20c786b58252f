// SPDX-License-Identifier: GPL-3.0-or-later
// Runs cases in child processes, many in each, so that one that crashes or hangs is known by its number and takes no
// other with it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rhexis::fuzz {

/// What became of a case.
struct Outcome {
    std::string kind;         ///< "refused", "stopped", "ran", ...: one word, the case's own
    std::uint64_t steps = 0;  ///< of time that it ran
    std::string fault;        ///< what must not be; empty: none
};

using Case = std::function<Outcome(std::uint64_t number)>;

struct Told {
    std::uint64_t number = 0;
    Outcome outcome;  ///< kind "crashed" or "hung" for a child that died in it
};

/// Runs `count` cases from number `first` on, in this order. limit_s: wall clock of each.
std::vector<Told> run_batches(std::uint64_t first, std::uint64_t count, unsigned limit_s, const Case& one);

}  // namespace rhexis::fuzz
