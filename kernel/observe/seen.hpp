// SPDX-License-Identifier: GPL-3.0-or-later
// What someone at the microscope can see: structures of the picture, brightness, the machine's panel; no measure that a
// person could not have.
#pragma once

#include "flow/percept.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {

/// Landmarks, in this order: "pupil" (size: radius), "incision" (size: half its width), "side_port" (likewise; where an
/// instrument needs one), and with a lens "lens_front" (front pole where it was before sculpting), "surface_at_tip"
/// (visible lens surface under the first instrument's tip), "groove_near", "groove_far" (ends on the front surface of
/// the largest patch that is gone, surgeon's side first), "groove_floor" (its deepest place), for each groove that can
/// be told apart "groove_N_start", "groove_N_end" (its ends, which turn with the lens; size: half its width) and
/// "groove_N_floor", and with a bag "capsulorhexis" (middle of the opening's edge; size: radius). With a chamber
/// "fragment_N" (middle of a piece, the largest first; size: radius of a ball of its volume) and "fragment_N_near" (its
/// tissue nearest to the first instrument's tip), with a capsule
/// "capsule_folds" (where a tip holds it) and "capsule_hole" (size: radius), with an iris that moves "iris_caught".
/// With a globe that rolls "limbus" (its middle; size: radius), with wounds and an iris "iris_prolapse" (at the outer
/// lip; size: length).
/// Those of an anterior capsule are in rhexis_marks.hpp, those of an implant in implant_marks.hpp.
Percept seen(const ObserveInput& input, const LensView& lens, bool iris);

/// What the eye's frame has, where it is in the room when the globe has rolled.
void put_into_room(const GlobeModel& model, const GlobeState& globe, Percept& percept);

/// Of the pupil, in the room.
Vec3 pupil_middle(const ObserveInput& input);

/// With a groove and a chamber "bridge": where the reflex of a groove that is held apart stops, because the halves
/// still hang together (size: radius of a disc of that share of a section 7 mm across; only while something holds).
void add_bridge_landmark(double share, const Vec3& place, const EyeAnatomy& eye, Percept& percept);

}  // namespace rhexis
