// SPDX-License-Identifier: GPL-3.0-or-later
// What a body's poses say of its motion: where it will be, and a pose with less noise.
#pragma once

#include "tracking/bodies/rigid_fit.hpp"

namespace rhexis::tracking {

struct FilterSettings {
    double position_gain = 1.0;  ///< of what a pose says against what was foreseen, 0 to 1; 1: poses as they are fitted
    double velocity_gain = 0.7;  ///< likewise of the motion, by which the next one is foreseen, 0 to 1
};

/// An alpha-beta filter of position and turn, which lags behind no steady motion [Kalata1984].
class MotionFilter {
public:
    explicit MotionFilter(const FilterSettings& settings) : settings_(settings) {}

    void begin(const Pose& pose, double time_s);
    /// A pose after the last one; returns it with less noise.
    Pose take(const Pose& pose, double time_s);
    [[nodiscard]] Pose foreseen(double time_s) const { return moved(pose_, motion_, time_s - time_s_); }
    [[nodiscard]] const Pose& pose() const { return pose_; }
    [[nodiscard]] const Motion& motion() const { return motion_; }
    [[nodiscard]] double time_s() const { return time_s_; }

private:
    FilterSettings settings_;
    Pose pose_{};
    Motion motion_{};
    double time_s_ = 0.0;
};

}  // namespace rhexis::tracking
