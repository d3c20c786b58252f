// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/symmetric_eigen.hpp"

#include <cmath>

namespace rhexis {
namespace {

/// Annihilates entry (p, q) of the symmetric a; r is the third index.
void rotate(Mat3& a, Mat3& v, int p, int q, int r) {
    const double apq = a(p, q);
    const double theta = (a(q, q) - a(p, p)) / (2.0 * apq);
    const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0);
    const double s = t * c;
    a(p, p) -= t * apq;
    a(q, q) += t * apq;
    a(p, q) = a(q, p) = 0.0;
    const double arp = a(r, p);
    const double arq = a(r, q);
    a(r, p) = a(p, r) = c * arp - s * arq;
    a(r, q) = a(q, r) = s * arp + c * arq;
    const Vec3 vp = v.col(p);
    const Vec3 vq = v.col(q);
    v.col(p) = c * vp - s * vq;
    v.col(q) = s * vp + c * vq;
}

}  // namespace

SymmetricEigen3 symmetric_eigen(const Mat3& matrix) {
    Mat3 a = matrix.selfadjointView<Eigen::Lower>();
    SymmetricEigen3 result;
    const double small = 1e-17 * a.norm();
    constexpr int max_sweeps = 12;  // quadratic convergence: 4 or 5 are enough for finite input
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        bool done = true;
        for (int r = 2; r >= 0; --r) {
            const int p = (r + 1) % 3 < (r + 2) % 3 ? (r + 1) % 3 : (r + 2) % 3;
            const int q = 3 - r - p;
            if (std::abs(a(p, q)) > small) {
                rotate(a, result.vectors, p, q, r);
                done = false;
            }
        }
        if (done) {
            break;
        }
    }
    result.values = a.diagonal();
    return result;
}

}  // namespace rhexis
