// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/pivot.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/numbers.hpp"

namespace rhexis::tracking {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

std::string tenths(double value) { return short_number(0.1 * std::round(10.0 * value)); }

/// The direction turned by R_i has a mean of length s: root mean square angle sqrt(2 (1 - s)), to second order.
double spread_of_mean(double length) { return degrees_per_radian * std::sqrt(2.0 * std::max(0.0, 1.0 - length)); }

Mat3 mean_rotation(std::span<const Pose> poses) {
    Mat3 mean = Mat3::Zero();
    for (const Pose& pose : poses) {
        mean += pose.orientation.toRotationMatrix() / static_cast<double>(poses.size());
    }
    return mean;
}

Status check_poses(std::span<const Pose> poses, int fewest, const char* where) {
    if (poses.size() < static_cast<std::size_t>(std::max(3, fewest))) {
        return Error{std::to_string(poses.size()) + " poses", where, "at least " + std::to_string(std::max(3, fewest))};
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (!poses[i].position.allFinite() || !(std::abs(poses[i].orientation.norm() - 1.0) < 1e-3)) {
            return Error{"pose " + std::to_string(i + 1) + " is not a finite place and a unit quaternion", where, ""};
        }
    }
    return success();
}

PivotCalibration solved_pivot(std::span<const Pose> poses) {
    const auto count = static_cast<Eigen::Index>(poses.size());
    MatX left(3 * count, 6);
    VecX right(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Pose& pose = poses[static_cast<std::size_t>(i)];
        left.block<3, 3>(3 * i, 0) = pose.orientation.toRotationMatrix();
        left.block<3, 3>(3 * i, 3) = -Mat3::Identity();
        right.segment<3>(3 * i) = -pose.position;
    }
    const Eigen::JacobiSVD<MatX> factors(left, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const VecX solution = factors.solve(right);
    const VecX& singular = factors.singularValues();
    const VecX off = left * solution - right;
    PivotCalibration result;
    result.tip = solution.head<3>();
    result.pivot = solution.tail<3>();
    result.residual_mm = std::sqrt(off.squaredNorm() / static_cast<double>(count));
    result.condition = singular[0] / singular[5];
    const MatX weighted = factors.matrixV().topRows<3>() * singular.cwiseInverse().asDiagonal();
    const double freedoms = static_cast<double>(3 * count - 6);
    result.tip_sigma_mm = std::sqrt(off.squaredNorm() / freedoms) * weighted.norm();
    return result;
}

}  // namespace

Result<PivotCalibration> calibrate_pivot(std::span<const Pose> poses, const PivotSettings& settings) {
    if (const Status status = check_poses(poses, settings.fewest_poses, "pivot"); !status) {
        return status.error();
    }
    const Eigen::JacobiSVD<Mat3> turning(mean_rotation(poses));
    const double spread = spread_of_mean(turning.singularValues()[0]);
    if (spread < settings.least_spread_deg) {
        return Error{"the direction that turned least is spread by " + tenths(spread) + " degrees", "pivot",
                     "at least " + tenths(settings.least_spread_deg) + " degrees: swing the hand through a cone of " +
                         tenths(5.0 * settings.least_spread_deg) + " degrees across or more"};
    }
    PivotCalibration result = solved_pivot(poses);
    result.spread_deg = spread;
    if (result.residual_mm > settings.most_residual_mm) {
        return Error{"the tip is " + short_number(0.001 * std::round(1e3 * result.residual_mm)) +
                         " mm from the pivot (root mean square)",
                     "pivot", "at most " + short_number(settings.most_residual_mm) + " mm: keep the tip in its hollow"};
    }
    return result;
}

Result<ShaftCalibration> calibrate_shaft(std::span<const Pose> poses, const Vec3& to_hand,
                                         const PivotSettings& settings) {
    if (const Status status = check_poses(poses, settings.fewest_poses, "shaft"); !status) {
        return status.error();
    }
    const Eigen::JacobiSVD<Mat3> turning(mean_rotation(poses), Eigen::ComputeFullU | Eigen::ComputeFullV);
    ShaftCalibration result;
    result.axis = turning.matrixV().col(0);
    result.residual_deg = spread_of_mean(turning.singularValues()[0]);
    result.spread_deg = spread_of_mean(turning.singularValues()[1]);
    if (result.spread_deg < settings.least_spin_deg) {
        return Error{"directions across the shaft are spread by " + tenths(result.spread_deg) + " degrees", "shaft",
                     "at least " + tenths(settings.least_spin_deg) + " degrees: turn it once around"};
    }
    if (result.residual_deg > settings.most_residual_deg) {
        return Error{"the shaft strays by " + tenths(result.residual_deg) + " degrees (root mean square)", "shaft",
                     "at most " + tenths(settings.most_residual_deg) + " degrees: turn it about itself only"};
    }
    const double towards = result.axis.dot(to_hand);
    if (!(std::abs(towards) > 1e-6 * to_hand.norm())) {
        return Error{"the vector to the hand is square to the shaft", "shaft", "one that looks along it"};
    }
    result.axis *= towards < 0.0 ? -1.0 : 1.0;
    return result;
}

Pose tip_pose(const Vec3& tip, const Vec3& axis, const Vec3& side) {
    RHEXIS_ASSERT(axis.cross(side).norm() > 1e-9);
    Mat3 turned;
    turned.col(2) = axis.normalized();
    turned.col(1) = axis.cross(side).normalized();
    turned.col(0) = turned.col(1).cross(turned.col(2));
    return {tip, Quat(turned)};
}

}  // namespace rhexis::tracking
