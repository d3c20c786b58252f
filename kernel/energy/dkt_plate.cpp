// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/dkt_plate.hpp"

namespace rhexis {
namespace {

using TiltRows = Eigen::Matrix<double, 2, 9>;  // a tilt, by the nine freedoms
using CurvatureRows = Eigen::Matrix<double, 3, 9>;

TiltRows corner_tilt(int corner) {
    TiltRows tilt = TiltRows::Zero();
    tilt(0, 3 * corner + 2) = -1.0;
    tilt(1, 3 * corner + 1) = 1.0;
    return tilt;
}

TiltRows middle_tilt(const PlaneCorners& p, int i, int j) {
    const Vec2 side = p[static_cast<std::size_t>(j)] - p[static_cast<std::size_t>(i)];
    const double length = side.norm();
    const Vec2 along = side / length;
    const Vec2 across(-along.y(), along.x());
    const TiltRows ends = corner_tilt(i) + corner_tilt(j);
    Eigen::Matrix<double, 1, 9> slope = -0.25 * along.transpose() * ends;
    slope[3 * i] -= 1.5 / length;
    slope[3 * j] += 1.5 / length;
    return along * slope + across * (0.5 * across.transpose() * ends);
}

void add_curvature(const Vec2& gradient, const TiltRows& tilt, CurvatureRows& curvature) {
    curvature.row(0) += gradient.x() * tilt.row(0);
    curvature.row(1) += gradient.y() * tilt.row(1);
    curvature.row(2) += gradient.y() * tilt.row(0) + gradient.x() * tilt.row(1);
}

}  // namespace

Mat9 dkt_stiffness(const PlaneCorners& corner, const Mat3& bending) {
    const PlaneCorners g = corner_gradients(corner);
    const double area = corner_area(corner);
    std::array<TiltRows, 3> ends;
    std::array<TiltRows, 3> middles;  // of the side from a to a + 1
    for (int a = 0; a < 3; ++a) {
        ends[static_cast<std::size_t>(a)] = corner_tilt(a);
        middles[static_cast<std::size_t>(a)] = middle_tilt(corner, a, (a + 1) % 3);
    }
    Mat9 stiffness = Mat9::Zero();
    for (std::size_t point = 0; point < 3; ++point) {
        Vec3 l = Vec3::Constant(0.5);  // area coordinates of the middle opposite to a corner
        l[static_cast<Eigen::Index>(point)] = 0.0;
        CurvatureRows curvature = CurvatureRows::Zero();
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            const double la = l[static_cast<Eigen::Index>(a)];
            const double lb = l[static_cast<Eigen::Index>(b)];
            add_curvature((4.0 * la - 1.0) * g[a], ends[a], curvature);
            add_curvature(4.0 * (la * g[b] + lb * g[a]), middles[a], curvature);
        }
        stiffness += area / 3.0 * curvature.transpose() * bending * curvature;
    }
    return stiffness;
}

}  // namespace rhexis
