// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/shell_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "energy/dkt_plate.hpp"
#include "energy/drilling_membrane.hpp"

namespace rhexis {
namespace {

inline double root(double a) { return std::sqrt(a); }
inline double larger(double a, double b) { return a > b ? a : b; }
#include "energy/shell_triangle.ipp"

Rest<double> rest_of(const ShellTriangle& triangle) {
    Rest<double> rest;
    const PlaneCorners gradient = corner_gradients(triangle.corner);
    for (std::size_t a = 0; a < 3; ++a) {
        for (int i = 0; i < 2; ++i) {
            rest.corner[a][i] = triangle.corner[a][i];
            rest.gradient[a][i] = gradient[a][i];
        }
    }
    for (int i = 0; i < 9; ++i) {
        for (int j = 0; j <= i; ++j) {
            rest.membrane[packed(i, j)] = triangle.membrane(i, j);
            rest.bending[packed(i, j)] = triangle.bending(i, j);
        }
        rest.frame.m[i / 3][i % 3] = triangle.frame(i / 3, i % 3);
    }
    rest.tension[0] = triangle.tension(0, 0);
    rest.tension[1] = triangle.tension(0, 1);
    rest.tension[2] = triangle.tension(2, 2);
    for (int i = 0; i < natural_length; ++i) {
        rest.natural[i / 5][i % 5] = triangle.natural[i];
    }
    return rest;
}

Now<double> now_of(const ShellCorners& corners) {
    Now<double> now;
    for (std::size_t a = 0; a < 3; ++a) {
        for (int i = 0; i < 3; ++i) {
            now.position[a][i] = corners.position[a][i];
            for (int j = 0; j < 3; ++j) {
                now.rotation[a].m[i][j] = corners.rotation[a](i, j);
            }
        }
    }
    return now;
}

Vec18 gradient_of(const Deformed<double>& d) {
    Vec18 gradient;
    for (int a = 0; a < 3; ++a) {
        const Triple<double> force = times(d.frame, d.gradient_force[a]);
        const Triple<double> moment = times(d.frame, d.lifted[a]);
        for (int i = 0; i < 3; ++i) {
            gradient[6 * a + i] = force[i];
            gradient[6 * a + 3 + i] = moment[i];
        }
    }
    return gradient;
}

Mat18 matrix_of(const Tangent<double>& t) {
    Mat18 result;
    for (int i = 0; i < 18; ++i) {
        for (int j = 0; j < 18; ++j) {
            result(i, j) = entry(t, i / 3, j / 3, i % 3, j % 3);
        }
    }
    return result;
}

}  // namespace

ShellTriangle shell_triangle(const std::array<Vec3, 3>& rest, double thickness, double young_modulus,
                             double poisson_ratio) {
    ShellTriangle triangle;
    const Vec3 side = rest[1] - rest[0];
    const Vec3 normal = side.cross(rest[2] - rest[0]).normalized();
    triangle.frame.col(0) = side.normalized();
    triangle.frame.col(1) = normal.cross(triangle.frame.col(0));
    triangle.frame.col(2) = normal;
    const Vec3 middle = (rest[0] + rest[1] + rest[2]) / 3.0;
    for (std::size_t a = 0; a < 3; ++a) {
        triangle.corner[a] = (triangle.frame.transpose() * (rest[a] - middle)).head<2>();
    }
    triangle.tension = thickness * plane_stress(young_modulus, poisson_ratio);
    triangle.membrane = drilling_stiffness(triangle.corner, triangle.tension, optimal_higher_share(poisson_ratio));
    triangle.bending = dkt_stiffness(triangle.corner, thickness * thickness / 12.0 * triangle.tension);
    return triangle;
}

Vec15 shell_deformation(const ShellTriangle& triangle, const ShellCorners& corners) {
    Deformed<double> d;
    find_deformation(rest_of(triangle), now_of(corners), d);
    Vec15 result;
    for (int a = 0; a < 3; ++a) {
        result.segment<5>(5 * a) << d.moved[a][0], d.moved[a][1], d.turned[a][0], d.turned[a][1], d.turned[a][2];
    }
    return result;
}

double shell_product(const ShellTriangle& triangle, const Vec15& a, const Vec15& b) {
    using Vec9 = Eigen::Matrix<double, 9, 1>;
    const auto in_plane = [](const Vec15& d) {
        return Vec9{{d[0], d[1], d[4], d[5], d[6], d[9], d[10], d[11], d[14]}};
    };
    const auto out = [](const Vec15& d) { return Vec9{{0.0, d[2], d[3], 0.0, d[7], d[8], 0.0, d[12], d[13]}}; };
    return in_plane(a).dot(triangle.membrane * in_plane(b)) + out(a).dot(triangle.bending * out(b));
}

double shell_energy(const ShellTriangle& triangle, const ShellCorners& corners) {
    Deformed<double> d;
    deform(rest_of(triangle), now_of(corners), d);
    return d.energy;
}

double shell_gradient(const ShellTriangle& triangle, const ShellCorners& corners, Vec18& gradient) {
    Deformed<double> d;
    deform(rest_of(triangle), now_of(corners), d);
    gradient = gradient_of(d);
    return d.energy;
}

double shell_hessian(const ShellTriangle& triangle, const ShellCorners& corners, ShellTangent kind, Vec18& gradient,
                     Mat18& hessian) {
    const Rest<double> rest = rest_of(triangle);
    Deformed<double> d;
    deform(rest, now_of(corners), d);
    gradient = gradient_of(d);
    Tangent<double> t;
    if (kind == ShellTangent::consistent) {
        tangent<double, true>(rest, d, t);
    } else {
        tangent<double, false>(rest, d, t);
    }
    hessian = matrix_of(t);
    return d.energy;
}

}  // namespace rhexis
