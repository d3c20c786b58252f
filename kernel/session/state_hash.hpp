// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that decides how a session goes on, as one number.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "flow/world.hpp"

namespace rhexis {

/// Positions, velocities, fractions, masks, bags, loads, contact memory, tools, settings, observer memory, step, seed.
std::uint64_t hash_state(const WorldState& world, std::span<const ToolState> tools,
                         const std::map<std::string, double>& settings, std::span<const double> observer_memory,
                         std::uint64_t step, std::uint64_t seed);

}  // namespace rhexis
