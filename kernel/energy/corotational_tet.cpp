// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/corotational_tet.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "base/assert.hpp"

namespace rhexis {

RestTet rest_tet(const TetPoints& rest) {
    Mat3 edges;
    edges << rest[1] - rest[0], rest[2] - rest[0], rest[3] - rest[0];
    RestTet tet;
    tet.volume = edges.determinant() / 6.0;
    RHEXIS_ASSERT(tet.volume > 0.0);
    const Mat3 inverse = edges.inverse();
    tet.gradient = {-(inverse.row(0) + inverse.row(1) + inverse.row(2)).transpose(), inverse.row(0).transpose(),
                    inverse.row(1).transpose(), inverse.row(2).transpose()};
    return tet;
}

Mat3 tet_gradient(const RestTet& tet, const TetPoints& x) {
    // differences first: positions far from the origin lose no digits
    return (x[1] - x[0]) * tet.gradient[1].transpose() + (x[2] - x[0]) * tet.gradient[2].transpose() +
           (x[3] - x[0]) * tet.gradient[3].transpose();
}

double load_bearing_share(double fraction, double floor) { return fraction > 0.0 ? std::max(fraction, floor) : 0.0; }

double corotational_tet_energy(const RestTet& tet, const Lame& material, const TetPoints& x) {
    return tet.volume * corotational_energy(corotational_point(tet_gradient(tet, x)), material);
}

Vec12 corotational_tet_gradient(const RestTet& tet, const Lame& material, const TetPoints& x) {
    const Mat3 stress = corotational_stress(corotational_point(tet_gradient(tet, x)), material);
    Vec12 result;
    for (int a = 0; a < 4; ++a) {
        result.segment<3>(3 * a) = tet.volume * (stress * tet.gradient[static_cast<std::size_t>(a)]);
    }
    return result;
}

Mat12 corotational_tet_hessian(const RestTet& tet, const Lame& material, const TetPoints& x, Tangent kind) {
    const CorotationalTangent tangent = corotational_tangent(corotational_point(tet_gradient(tet, x)), material, kind);
    Mat12 result;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
            const Vec3& rest_a = tet.gradient[static_cast<std::size_t>(a)];
            const Vec3& rest_b = tet.gradient[static_cast<std::size_t>(b)];
            result.block<3, 3>(3 * a, 3 * b) = tet.volume * tangent.block(rest_a, rest_b);
        }
    }
    return result;
}

}  // namespace rhexis
