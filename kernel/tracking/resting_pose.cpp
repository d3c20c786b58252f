// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/resting_pose.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

namespace rhexis::tracking {
namespace {

/// From one pose to another: shift [mm] and turn [rad].
Vec6 between(const Pose& from, const Pose& to) {
    const Eigen::AngleAxisd turn((to.orientation * from.orientation.conjugate()).normalized());
    const double angle = turn.angle() > std::numbers::pi ? turn.angle() - 2.0 * std::numbers::pi : turn.angle();
    Vec6 result;
    result << to.position - from.position, angle * turn.axis();
    return result;
}

}  // namespace

const Pose& RestingPose::take(const Fit& fit, double time_s) {
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> factor(fit.covariance);
    const double weight = 1.0 / fit.covariance.topLeftCorner<3, 3>().trace();
    const double passed_s = time_s - time_s_;
    time_s_ = time_s;
    if (mean_ && settings_.average_s > 0.0 && factor.info() == Eigen::Success) {
        const Vec6 off = between(*mean_, fit.pose);
        const Vec6 sigmas = factor.matrixL().solve(off);
        off_ += (sigmas - off_) / settings_.settled_poses;
        if (off_.cwiseAbs().maxCoeff() < settings_.moved_sigmas) {
            weight_ = weight_ * std::exp(-passed_s / settings_.average_s) + weight;
            const double gain = weight / weight_;
            *mean_ = moved(*mean_, {off.head<3>(), off.tail<3>()}, gain);
            return *mean_;
        }
    }
    mean_ = fit.pose;
    weight_ = weight;
    off_.setZero();
    return *mean_;
}

}  // namespace rhexis::tracking
