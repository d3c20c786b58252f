// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a snapshot, perhaps read from a file, can be the state of a world.
#pragma once

#include "base/result.hpp"
#include "session/session.hpp"

namespace rhexis {

/// Sizes, indices, settings and finite numbers; names the first part that does not fit.
Status check_fit(const Snapshot& snapshot, const WorldModel& world, std::size_t observer_memory);

}  // namespace rhexis
