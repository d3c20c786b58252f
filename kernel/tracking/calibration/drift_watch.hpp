// SPDX-License-Identifier: GPL-3.0-or-later
// Which camera was bumped, told by what it sees against what the others say.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking {

/// Of one exposure and one camera: what it saw, less what poses that were fitted to the OTHER cameras predict.
struct CameraResidual {
    Vec2 mean_px = Vec2::Zero();  ///< over its markers
    int count = 0;                ///< of markers; 0: it saw none, and the mean says nothing
};

struct DriftSettings {
    double window_s = 0.5;   ///< that medians are taken of
    double limit_px = 0.5;   ///< a median beyond it is drift
    int fewest_frames = 30;  ///< with markers, in the window
    double alone = 1.3;      ///< times the next camera's median: then it is this camera that moved
};

/// A camera that is off.
struct Drift {
    int camera = 0;                 ///< the one that is farthest off
    Vec2 median_px = Vec2::Zero();  ///< of its residuals, each coordinate by itself
    bool alone = false;             ///< clearly farther off than any other one; else the whole rig wants calibrating
};

/// What DriftWatch remembers.
struct DriftState {
    struct Seen {
        double time_s = 0.0;
        Vec2 mean_px = Vec2::Zero();
    };
    std::vector<std::deque<Seen>> cameras{};  ///< of each the residuals of the window, oldest first
};

/// Medians over a window: residuals of a half-hidden sphere are great but few and do not move them.
class DriftWatch {
public:
    explicit DriftWatch(const DriftSettings& settings = {}) : settings_(settings) {}

    /// One exposure, a residual for each camera; times rise. What is older than the window is forgotten.
    void add(DriftState& state, double time_s, std::span<const CameraResidual> residuals) const;

    /// None: no camera is off, or too little was seen to say so.
    [[nodiscard]] std::optional<Drift> drift(const DriftState& state) const;

private:
    DriftSettings settings_;
};

}  // namespace rhexis::tracking
