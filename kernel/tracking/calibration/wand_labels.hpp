// SPDX-License-Identifier: GPL-3.0-or-later
// Which spot of an image is which sphere of the wand.
#pragma once

#include <span>
#include <vector>

#include "tracking/calibration/wand.hpp"

namespace rhexis::tracking {

/// A view with its spots in the wand's order.
struct LabelledView {
    int camera = 0;
    std::vector<Vec2> pixels{};
    std::vector<Vec2> directions{};  ///< undistorted
};

struct LabelledFrame {
    std::vector<LabelledView> views{};
};

/// By the gaps between three spots: the images of A, B and C on a line are gaps in the ratio AB / BC times the ratio of
/// the depths of C and A, which is near 1: a wand that points at the camera may be taken the other way round. Views
/// that fit neither way, or both, are left out.
LabelledFrame label_by_gaps(std::span<const Camera> cameras, const Wand& wand, const WandFrame& frame);

/// By poses that are nearly right, of two spots or three: so that the rays of all cameras meet best, and at the wand's
/// length. Views that fit both ways are left out; of a frame that one camera saw nothing is left.
LabelledFrame label_by_poses(std::span<const Camera> cameras, const Wand& wand, const WandFrame& frame);

/// Point nearest to the rays of directions, by least squares, each seen by its camera; 2 rays at least.
Vec3 meeting_point(std::span<const Camera> cameras, const LabelledFrame& frame, std::size_t label);

}  // namespace rhexis::tracking
