// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what a world must be for a step to make sense.
#pragma once

#include "flow/world.hpp"
#include "physics/physics.hpp"

namespace rhexis {

/// Names the first thing that cannot be stepped: the solid, the element or field, its value and its range.
Status check_world(const WorldModel& model, const PhysicsSettings& settings);

}  // namespace rhexis
