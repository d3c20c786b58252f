// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the solid shape of an instrument and where it is within a step.
#pragma once

#include <vector>

#include "flow/bag.hpp"
#include "flow/tool.hpp"

namespace rhexis {

/// Exact distance to a rounded cone: the smallest of |p - c(s)| - r(s) over the balls along its axis.
SurfaceDistance cone_distance(const RoundedCone& cone, const Vec3& point);

/// To the nearest part of a tool, for a point in the tool's frame, with parts that are thinner taken to have at least
/// this radius [mm]. A tool without parts is infinitely far.
SurfaceDistance tool_distance(const ToolModel& tool, const Vec3& point, double least_radius = 0.0);

/// Pose at share s of a step, 0: previous_pose, 1: pose. Normalised linear interpolation of the orientation, the short
/// way round: no trigonometry, so the same bits on every machine.
Pose pose_within(const ToolState& tool, double s);

/// The part of a tool's step from share `from` to share `to`.
ToolState part_of_step(const ToolState& tool, double from, double to);

/// An axis-aligned box [mm].
struct Box {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);

    void add(const Vec3& point, double radius);
    [[nodiscard]] bool holds(const Vec3& point) const {
        return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
    }
};

/// Square of a point's distance from a box, 0 inside [mm^2].
inline double square_to(const Box& box, const Vec3& point) {
    return (point.cwiseMax(box.low).cwiseMin(box.high) - point).squaredNorm();
}

/// Box around everything that a tool passes through in a step.
Box swept_box(const ToolModel& model, const ToolState& tool);

/// Farthest that any point of a tool's parts travels in a step [mm].
double travel(const ToolModel& model, const ToolState& tool);

/// Likewise of what of it comes within half a millimetre of a box in the step; of all of it where its tip goes farther
/// than 4 mm.
double travel_near(const ToolModel& model, const ToolState& tool, const Box& box);

/// Whether anything of a tool that travels so far in a step comes to what has these nodes, no place farther than 0.8 mm
/// from the nearest.
bool comes_near(const ToolModel& model, const ToolState& tool, double travel, const std::vector<Vec3>& nodes);

/// Radius of a tool's thinnest end [mm].
double thinnest(const ToolModel& model);

}  // namespace rhexis
