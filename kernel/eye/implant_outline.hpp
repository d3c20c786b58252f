// SPDX-License-Identifier: GPL-3.0-or-later
// Inside eye: where the haptics of an implant run, and how large its triangles are.
#pragma once

#include <vector>

#include "eye/implant.hpp"
#include "math/turn.hpp"

namespace rhexis {

inline constexpr double haptic_root = 0.7;  ///< angle of the upper haptic's root on the optic's rim [rad]

/// Half the angle that a root takes on the rim [rad].
double half_root(const ImplantShape& shape);

/// A place on the upper haptic: its middle, the way outwards along it, its width and the triangles' edge there [mm].
struct HapticSection {
    Vec2 middle;
    Vec2 along;
    double width;
    double edge;
};

/// The upper haptic from its root on the rim to its tip, in steps of about the triangles' edges; the root left out.
std::vector<HapticSection> haptic_sections(const ImplantShape& shape, double scale);

/// Edge of the triangles at a place of the optic or the root of a haptic [mm]; scale: 1 for 743 triangles.
double wanted_edge(const ImplantShape& shape, const Vec2& place, double scale);

}  // namespace rhexis
