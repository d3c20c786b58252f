// SPDX-License-Identifier: GPL-3.0-or-later
// What the shaders of an eye are told of a frame, and which of their features it needs.
#pragma once

#include <vector>

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"

namespace rhexis {

/// Radius through which the lens is seen: the pupil, or all that lies behind the limbus where there is no iris. [mm]
double opening_of(const EyeAnatomy& eye);
/// Where the pupil's edge is drawn into a mouth: its direction from the axis, and how far it has come from where it was
/// [mm]; 0: it is not; negative: it is drawn towards the wound.
Vec3 caught_edge(const Frame& frame);
/// How far Descemet's membrane hangs from a wound towards the axis. [mm]
double flap_of(const Frame& frame);
bool has_sheets(const Frame& frame);

/// Set the parameters of eye_front.glsl, bag_support.glsl and pupil_contents.glsl, with the program in use.
void set_anatomy(const Program& program, const EyeAnatomy& eye);
void set_bag(const Program& program, const Frame& frame);
void set_harm(const Program& program, const Frame& frame);
void set_crumbs(const Program& program, const Frame& frame);

/// What a scene may show beyond a healthy eye, as the shaders name it (ProgramVariants).
std::vector<const char*> feature_names();
/// Bit i: the i-th shows. in_pupil: also those that do not reach beyond the pupil.
unsigned features_of(const Frame& frame, bool in_pupil);
/// The bit of crumbs.
unsigned crumb_feature();

}  // namespace rhexis
