// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/motion_filter.hpp"

#include <numbers>

namespace rhexis::tracking {

void MotionFilter::begin(const Pose& pose, double time_s) {
    pose_ = pose;
    motion_ = {};
    time_s_ = time_s;
}

Pose MotionFilter::take(const Pose& pose, double time_s) {
    const double passed_s = time_s - time_s_;
    if (passed_s <= 0.0) {
        return pose_;
    }
    const Pose expected = foreseen(time_s);
    const Vec3 shift = pose.position - expected.position;
    const Eigen::AngleAxisd off((pose.orientation * expected.orientation.conjugate()).normalized());
    const double angle = off.angle() > std::numbers::pi ? off.angle() - 2.0 * std::numbers::pi : off.angle();
    const Vec3 turn = angle * off.axis();
    pose_.position = expected.position + settings_.position_gain * shift;
    pose_.orientation =
        (Quat(Eigen::AngleAxisd(settings_.position_gain * angle, off.axis())) * expected.orientation).normalized();
    motion_.velocity += settings_.velocity_gain / passed_s * shift;
    motion_.turning += settings_.velocity_gain / passed_s * turn;
    time_s_ = time_s;
    return pose_;
}

}  // namespace rhexis::tracking
