// SPDX-License-Identifier: GPL-3.0-or-later
// What shows of a capsulorhexis on the way: where the tear ends, where its flap can be taken hold of, and what the
// forceps hold.
#pragma once

#include "flow/percept.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {

/// Landmarks: "lens_front" (front pole, with the lens as it lies now), "viscoelastic" (there; size: share of the
/// chamber that it fills), "tear_tip" (end of the tear that went on last), "margin" (0.8 mm behind it on the edge of
/// what stays), "flap" (a place near it to take hold of: of what is folded over, or of the flat flap, size 1 or 0),
/// "held" (middle of what the forceps hold) and "rim" (middle of the closed opening; size: mean radius). What lies
/// behind the iris is not visible. membrane: number of the anterior capsule.
void add_rhexis_landmarks(const ObserveInput& input, const RhexisShape& rhexis, int membrane,
                          std::vector<Landmark>& marks);

}  // namespace rhexis
