// SPDX-License-Identifier: GPL-3.0-or-later
// Which body some points are, by the distances between them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

struct Identified {
    std::vector<int> points{};  ///< by marker: index of its point; -1: it is not among them
    Pose pose{};                ///< of the body, by the best rigid fit of the markers that are [Umeyama1991]
    int markers = 0;            ///< that were found
    double worst_mm = 0.0;      ///< farthest that one is from its point
};

/// The most markers of a body, at least 3, whose distances are those of points within `tolerance_mm` and that a
/// rotation brings to them, not a mirror; of equally many, the best fit. None: it is not there. taken: points that are
/// of others, by index.
std::optional<Identified> identify(const MarkerBody& body, std::span<const Vec3> points, const std::vector<bool>& taken,
                                   double tolerance_mm);

/// The rotation and shift that bring markers to their points with the least sum of squares; a mirror never. The points
/// do not lie in one line.
Pose fitted(std::span<const Vec3> markers, std::span<const Vec3> points);

}  // namespace rhexis::tracking
