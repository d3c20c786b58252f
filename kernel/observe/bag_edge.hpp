// SPDX-License-Identifier: GPL-3.0-or-later
// Inside observe: where the edge of the bag comes out behind the iris.
#pragma once

#include "math/types.hpp"

namespace rhexis {

struct ObserveInput;

/// From the edge of the bag to the ciliary body [mm].
inline constexpr double zonule_length = 1.25;

struct BagEdge {
    double inside = 0.0;        ///< of the pupil's edge, towards the middle [mm]; negative: the iris hides it
    Vec3 place = Vec3::Zero();  ///< where it is farthest inside, in the eye's frame [mm]
};
/// The scene has a rigid bag.
BagEdge bag_edge(const ObserveInput& input);

}  // namespace rhexis
