// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/nine_term_plate.hpp"

#include <Eigen/LU>

namespace rhexis::bench {

Mat9 nine_term_stiffness(const PlaneCorners& corner, const Mat3& bending) {
    Mat9 fit;
    for (int a = 0; a < 3; ++a) {
        const double x = corner[static_cast<std::size_t>(a)].x();
        const double y = corner[static_cast<std::size_t>(a)].y();
        fit.row(3 * a) << 1.0, x, y, x * x, x * y, y * y, x * x * x, x * y * y, y * y * y;
        fit.row(3 * a + 1) << 0.0, 0.0, 1.0, 0.0, x, 2.0 * y, 0.0, 2.0 * x * y, 3.0 * y * y;  // w,y
        fit.row(3 * a + 2) << 0.0, -1.0, 0.0, -2.0 * x, -y, 0.0, -3.0 * x * x, -y * y, 0.0;   // -w,x
    }
    const Mat9 terms = fit.inverse();
    Mat9 stiffness = Mat9::Zero();
    for (std::size_t a = 0; a < 3; ++a) {  // curvature is linear: the middles of the sides integrate exactly
        const Vec2 p = 0.5 * (corner[a] + corner[(a + 1) % 3]);
        Eigen::Matrix<double, 3, 9> curvature = Eigen::Matrix<double, 3, 9>::Zero();
        curvature.row(0) << 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 6.0 * p.x(), 0.0, 0.0;
        curvature.row(1) << 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 2.0 * p.x(), 6.0 * p.y();
        curvature.row(2) << 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 4.0 * p.y(), 0.0;
        const Eigen::Matrix<double, 3, 9> rows = curvature * terms;
        stiffness += corner_area(corner) / 3.0 * rows.transpose() * bending * rows;
    }
    return stiffness;
}

ShellTriangle nine_term_triangle(const std::array<Vec3, 3>& rest, double thickness, double young_modulus,
                                 double poisson_ratio) {
    ShellTriangle triangle = shell_triangle(rest, thickness, young_modulus, poisson_ratio);
    triangle.bending = nine_term_stiffness(triangle.corner, thickness * thickness / 12.0 * triangle.tension);
    return triangle;
}

}  // namespace rhexis::bench
