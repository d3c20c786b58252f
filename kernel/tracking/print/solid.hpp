// SPDX-License-Identifier: GPL-3.0-or-later
// Closed shells of triangles, and the file that a printer's program reads.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

/// Counter-clockwise from outside.
using Triangle = std::array<Vec3, 3>;
using Solid = std::vector<Triangle>;

/// Distance from an axis, and height along it from where it begins.
struct ProfilePoint {
    double radius;
    double height;
};

struct Axis {
    Vec3 from;
    Vec3 along;  ///< unit
};

/// A profile turned about an axis, with the solid on its left as it goes; its ends lie on the axis, or it is a loop.
Solid revolved(const Axis& axis, std::span<const ProfilePoint> profile);

/// One closed shell of triangles that share corners to within a millionth of a millimetre: those without an area are
/// left out, and each hole is closed by a fan about its middle. The error: an edge of more than two triangles, or two
/// that turn against each other. where: for it.
Result<Solid> closed_shell(std::span<const Vec3> corners, const std::string& where);

/// Binary STL: 80 bytes that say nothing, a count, and for each triangle its normal, corners and two bytes more.
/// Triangles without an area at the file's precision, of 32 bits, are left out.
std::string binary_stl(const Solid& solid);

}  // namespace rhexis::tracking
