// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a snapshot, perhaps read from a file, can be the state of a world.
#pragma once

#include "base/result.hpp"
#include "session/session.hpp"

namespace rhexis {

/// Whether the snapshot's splits can be made in the scene's meshes: before anything else of it is used.
Status check_splits(const Snapshot& snapshot, const WorldModel& base);

/// Sizes, indices, settings and finite numbers; names the first part that does not fit.
Status check_fit(const Snapshot& snapshot, const WorldModel& world, std::size_t observer_memory);

}  // namespace rhexis
