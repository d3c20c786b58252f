// SPDX-License-Identifier: GPL-3.0-or-later
// Pose of a body that mostly rests: the mean of what was seen since it moved last.
#pragma once

#include <optional>

#include "tracking/bodies/rigid_fit.hpp"

namespace rhexis::tracking {

struct RestingSettings {
    double average_s = 0.5;  ///< poses older than this count ever less; 0: the last pose is told as it is
    double moved_sigmas =
        2.5;  ///< a mean over `settled_poses` that is farther off than this in any direction has moved
    double settled_poses = 6.0;
};

/// Weighted by what each pose's fit says of its certainty, so that few cameras add little. What moved is followed at
/// once: the mean begins anew with its pose.
class RestingPose {
public:
    explicit RestingPose(const RestingSettings& settings) : settings_(settings) {}

    /// Times rise. Returns the mean with this pose in it.
    const Pose& take(const Fit& fit, double time_s);
    void forget() { mean_.reset(); }
    /// None: nothing was seen since forget().
    [[nodiscard]] const std::optional<Pose>& mean() const { return mean_; }

private:
    RestingSettings settings_;
    std::optional<Pose> mean_{};
    double time_s_ = 0.0;
    double weight_ = 0.0;
    Vec6 off_ = Vec6::Zero();  ///< smoothed, by standard deviations
};

}  // namespace rhexis::tracking
