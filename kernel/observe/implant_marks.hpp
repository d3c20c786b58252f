// SPDX-License-Identifier: GPL-3.0-or-later
// What shows of an implant and of the bag that it goes into.
#pragma once

#include "flow/percept.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {

/// Landmarks: "optic" (middle; size: radius), "haptic_leading" and "haptic_trailing" (their ends), either with "_elbow"
/// (where its arm bends round) and "_middle" (of the arm from there to its end), and of a bag that is a membrane
/// "bag_rim" (middle of the opening; size: mean radius) and "bag_equator" (likewise). With viscoelastic in the scene
/// "viscoelastic" (in the pupil; size: share of the chamber that it fills). What lies behind the iris is not visible,
/// of a circle as soon as a part of it does; nor is an implant that has not come into the eye.
void add_implant_landmarks(const ObserveInput& input, const ImplantPlace& implant, const BagPlace* bag,
                           std::vector<Landmark>& marks);

}  // namespace rhexis
