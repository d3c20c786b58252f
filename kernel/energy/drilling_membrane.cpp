// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/drilling_membrane.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace rhexis {
namespace {

using StressColumns = Eigen::Matrix<double, 9, 3>;
using RotationRows = Eigen::Matrix<double, 3, 9>;

/// Forces on the freedoms per constant stress resultant: L of [Felippa2003], whose alpha is 3/2.
StressColumns lumping(const PlaneCorners& p) {
    constexpr double alpha = 1.5;
    StressColumns l = StressColumns::Zero();
    for (int a = 0; a < 3; ++a) {
        const Vec2 to_next = p[at((a + 1) % 3)] - p[at(a)];
        const Vec2 from_last = p[at(a)] - p[at((a + 2) % 3)];
        const Vec2 across = p[at((a + 2) % 3)] - p[at((a + 1) % 3)];
        // x_kj and y_jk in the paper's words, j the next corner and k the last
        l.row(3 * a) = 0.5 * Vec3(-across.y(), 0.0, across.x()).transpose();
        l.row(3 * a + 1) = 0.5 * Vec3(0.0, across.x(), -across.y()).transpose();
        l.row(3 * a + 2) = alpha / 12.0 *
                           Vec3(-across.y() * (from_last.y() - to_next.y()), across.x() * (to_next.x() - from_last.x()),
                                2.0 * (to_next.x() * to_next.y() - from_last.x() * from_last.y()))
                               .transpose();
    }
    return l;
}

/// Corner rotations less that of the triangle with straight sides, (v,x - u,y) / 2.
RotationRows relative_rotations(const PlaneCorners& gradient) {
    RotationRows t = RotationRows::Zero();
    for (int row = 0; row < 3; ++row) {
        for (int a = 0; a < 3; ++a) {
            t(row, 3 * a) = 0.5 * gradient[at(a)].y();
            t(row, 3 * a + 1) = -0.5 * gradient[at(a)].x();
        }
        t(row, 3 * row + 2) = 1.0;
    }
    return t;
}

}  // namespace

double optimal_higher_share(double poisson_ratio) {
    return std::max(0.5 * (1.0 - 4.0 * poisson_ratio * poisson_ratio), 0.01);
}

Mat9 drilling_stiffness(const PlaneCorners& corner, const Mat3& membrane, double higher) {
    constexpr double beta[3][3] = {{1.0, 2.0, 1.0}, {0.0, 1.0, -1.0}, {-1.0, -1.0, -2.0}};
    const PlaneCorners g = corner_gradients(corner);
    const double area = corner_area(corner);
    // strain (11, 22, shear) per strain along each side, the side s from corner s to s + 1
    Mat3 from_sides;
    Vec3 length2;
    for (int s = 0; s < 3; ++s) {
        const Vec2& ga = g[at(s)];
        const Vec2& gb = g[at((s + 1) % 3)];
        length2[s] = (corner[at((s + 1) % 3)] - corner[at(s)]).squaredNorm();
        from_sides.col(s) = -length2[s] * Vec3(ga.x() * gb.x(), ga.y() * gb.y(), ga.x() * gb.y() + ga.y() * gb.x());
    }
    const Mat3 natural = from_sides.transpose() * membrane * from_sides;
    std::array<Mat3, 3> at_corner;  // strains along the sides per corner rotation
    for (int p = 0; p < 3; ++p) {
        for (int s = 0; s < 3; ++s) {
            for (int a = 0; a < 3; ++a) {
                at_corner[at(p)](s, a) = 2.0 * area / 3.0 * beta[(s + 3 - p) % 3][(a + 3 - p) % 3] / length2[s];
            }
        }
    }
    Mat3 higher_stiffness = Mat3::Zero();
    for (int p = 0; p < 3; ++p) {
        const Mat3 middle = 0.5 * (at_corner[at(p)] + at_corner[at((p + 1) % 3)]);
        higher_stiffness += area * middle.transpose() * natural * middle;
    }
    const StressColumns l = lumping(corner);
    const RotationRows t = relative_rotations(g);
    return l * membrane * l.transpose() / area + 0.75 * higher * t.transpose() * higher_stiffness * t;
}

}  // namespace rhexis
