// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the material points of a solid that tools may meet within a step. A point is a ball of tissue; what
// is left of one decides whether it is there, as it decides what is drawn. So a tool meets tissue where it is, to a
// fraction of a fine tetrahedron, whatever the mesh; vertices of a coarse mesh stay in its way until all around them is
// spent.
#pragma once

#include <span>
#include <vector>

#include "flow/solid.hpp"
#include "flow/tool.hpp"
#include "physics/contact/contact_point.hpp"

namespace rhexis {

/// A tool, and how far from it tissue may touch it within the step.
struct ToolReach {
    const ToolModel* tool = nullptr;
    Pose pose;            ///< at the start of the step
    double margin = 0.0;  ///< what it moves, and what else comes into question [mm]
    // Where it holds tissue by suction, what lies farther off comes into question too.
    Vec3 mouth = Vec3::Zero();  ///< in the tool's frame [mm]
    double mouth_radius = 0.0;  ///< how far around that; 0: it holds nothing [mm]
    double mouth_margin = 0.0;  ///< instead of the margin, and no less [mm]
};

struct NearPoint {
    ContactPoint at;
    int reach = 0;  ///< index of the tool's
};

/// For a tool's part that is thinner than points lie apart: the radius, as a share of that, with which it cannot slip
/// between them.
inline constexpr double resolved_by_points = 0.38;

/// Ordered by (point, tool). spacings: how far the points of each coarse tetrahedron lie apart (ContactSurface keeps
/// them) [mm]; dt [s]: the step, in which tissue moves too.
void find_near_points(const SolidModel& model, const std::vector<double>& spacings, const SolidState& state,
                      std::span<const ToolReach> reaches, double dt, std::vector<NearPoint>& points);

}  // namespace rhexis
