// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tear goes on meshes of different kinds.
#pragma once

#include <vector>

#include "scenes/membranes.hpp"

namespace rhexis::scenes {

/// Places of one tip, in order.
struct TearPath {
    std::vector<Vec3> places;  ///< [mm]
    double cpu_s = 0.0;
    double simulated_s = 0.0;
};

/// A round sheet of 4 mm radius with a slit across the pull in its middle tears until its tip nears the edge. across:
/// strength across the fibres over that along them.
TearPath tear_path(TriMesh mesh, const Vec3& fibre, double across);

/// Largest distance of a path's places from a line through the middle at an angle [mm, rad].
double off_line(const TearPath& path, double angle);

/// Of the line from the middle to where a path ends [rad].
double angle_of(const TearPath& path);

/// About the axis [rad].
TriMesh turned(TriMesh mesh, double angle);

/// Slope of log y against log x.
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace rhexis::scenes
