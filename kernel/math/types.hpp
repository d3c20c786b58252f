// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that names Eigen types. Results of Eigen expressions are never held in `auto`.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rhexis {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;  // translation or force, then rotation vector or torque
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;
using Quat = Eigen::Quaterniond;

/// Position and orientation of a rigid body: x_world = orientation * x_body + position.
struct Pose {
    Vec3 position = Vec3::Zero();  ///< [mm]
    Quat orientation = Quat::Identity();

    [[nodiscard]] Vec3 to_world(const Vec3& body) const { return orientation * body + position; }
    [[nodiscard]] Vec3 to_body(const Vec3& world) const { return orientation.conjugate() * (world - position); }
};

}  // namespace rhexis
