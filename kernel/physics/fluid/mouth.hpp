// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what stands before the open mouth of an aspirating tip, and how that shuts it.
//
// Points are spread over the mouth and pushed out to the rounded end that contact knows. A point is covered by what it
// finds within `seal` in front of it, by the nearest first: iris, capsule, debris, lens. Soft tissue shuts the mouth
// before the last point is covered, because it bulges into the bore, and what has shut it may then be farther away.
// Ultrasound clears what is before it: then only a piece, which follows the flow, keeps it shut from there.
#pragma once

#include <span>
#include <vector>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {

/// Constant for one tool.
struct MouthProbe {
    Mouth mouth;
    std::vector<Vec3> points;  ///< on the end's surface, in the tool's frame [mm]; empty: the tool does not aspirate
    double area = 0.0;         ///< of the bore [mm^2]
};

MouthProbe mouth_probe(const ToolModel& tool);

/// Shares covered, and how far the mouth is open. Suction, flow and hold are left at 0.
TipState look_at_mouth(const WorldModel& model, const WorldState& state, int tool, const ToolState& tool_state,
                       const MouthProbe& probe);

/// A fine tetrahedron right before a mouth.
struct BeforeMouth {
    int fine = 0;
    double distance = 0.0;  ///< of its middle from the mouth's [mm]
};

/// Tissue of solid 0 that suction can draw at, within the bore and kept_seal before it, nearest first. pose: of the
/// tool when the solid is where `state` says.
std::vector<BeforeMouth> before_mouth(const WorldModel& model, const WorldState& state, int tool, const Mouth& mouth,
                                      const Pose& pose);

/// The part of what a tip holds that lens tissue bears [uN].
double hold_of_lens(const TipState& tip);

/// How open a mouth is of which this share is covered, 1 to 0. was_shut: lens tissue shut it before.
double open_share(double covered, bool was_shut);

/// 20 mmHg: less than this holds neither capsule nor iris [Pa].
inline constexpr double least_suction = 2666.0;

/// Tissue nearer to the mouth than this is held by suction [mm].
inline constexpr double seal = 0.15;

/// A mouth that tissue has shut stays shut while it is as near as this: it bulges towards it, and slides over the metal
/// around it [mm]. Proposal: what ultrasound clears and a fine tetrahedron.
inline constexpr double kept_seal = 0.5;

}  // namespace rhexis
