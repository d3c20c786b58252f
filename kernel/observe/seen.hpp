// SPDX-License-Identifier: GPL-3.0-or-later
// What someone at the microscope can see: structures of the picture, brightness, the machine's panel; no measure that a
// person could not have.
#pragma once

#include "flow/percept.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {

/// Landmarks, in this order: "pupil" (size: radius), "incision" (size: half its width), and with a lens "lens_front"
/// (front pole where it was before sculpting), "surface_at_tip" (visible lens surface under the first instrument's
/// tip), "groove_near", "groove_far" (its ends on the front surface, surgeon's side first) and "groove_floor" (deepest
/// place).
Percept seen(const ObserveInput& input, const LensView& lens, bool iris);

}  // namespace rhexis
