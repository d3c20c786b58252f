// SPDX-License-Identifier: GPL-3.0-or-later
// A board held before the cameras of a synthetic rig.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracking/calibration/board.hpp"
#include "tracking/sources/frame_source.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking::synthetic {

/// As good as any to begin with.
inline constexpr GridPlan standard_board{13, 9, 14.0, GridKind::dots};

/// Where a board is held before one camera, in its frame: near and far, slanted to all sides, its dots wholly in the
/// image. Fewer than `views`: the board is too large for the camera. The same for the same seed.
std::vector<Pose> held_poses(const TrueCamera& camera, const GridPlan& plan, int views, std::uint64_t seed);

/// What a detector would give of such views: each point with noise of `noise_px` each way.
std::vector<BoardView> held_board(const TrueCamera& camera, const GridPlan& plan, int views, double noise_px,
                                  std::uint64_t seed);

/// Images of such views: in each set every camera has its own turn with the board, alone. The error: the board is too
/// large for a camera, which is named.
Result<std::unique_ptr<FrameSource>> film_boards(const SyntheticRig& rig, const GridPlan& plan, int views,
                                                 std::uint64_t seed);

}  // namespace rhexis::tracking::synthetic
