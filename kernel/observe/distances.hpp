// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between instruments and the surfaces that they should keep clear of. Only + - * / and sqrt: the same bits
// on every machine.
#pragma once

#include <functional>

#include "flow/bag.hpp"
#include "flow/eye_model.hpp"
#include "flow/tool.hpp"

namespace rhexis {

/// From a point in the bag's frame to the posterior half of the bag's wall [mm], >= 0 on both sides of it.
double posterior_distance(const BagShape& shape, const Vec3& point);

/// From a point in the bag's frame to the wall that is there: the anterior opening is no wall, its rim is. >= 0 [mm].
double bag_wall_distance(const BagModel& bag, const Vec3& point);

/// From a point in the eye's frame to the iris, a flat ring from the pupil's edge to the limbus. >= 0 [mm].
double iris_distance(const EyeAnatomy& eye, const Vec3& point);

/// From a point in the eye's frame to the back of the cornea; negative in front of it. [mm]
double endothelium_distance(const EyeAnatomy& eye, const Vec3& point);

/// Least of distance(point) - radius over the axes of the tool's cones: the gap between tool and surface; negative when
/// they overlap. [mm]
double tool_gap(const ToolModel& model, const Pose& pose, const std::function<double(const Vec3&)>& distance);

}  // namespace rhexis
