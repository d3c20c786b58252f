// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/rotation.hpp"

#include <algorithm>
#include <cmath>

#include "math/symmetric_eigen.hpp"

namespace rhexis {
namespace {

/// Below this denominator over I^1.5 the closed form loses more than half of its digits.
constexpr double singular = 1e-6;

/// Largest root of the quartic. sqrt(3 I) bounds it from above, so Newton's iterates fall monotonically to it.
double trace_of_stretch(double i1, double e2, double j) {
    double f = std::sqrt(3.0 * i1);
    constexpr int max_iterations = 50;  // 4 to 8 unless the root is nearly double
    for (int k = 0; k < max_iterations; ++k) {
        const double f2 = f * f;
        const double value = f2 * f2 - 2.0 * i1 * f2 - 8.0 * j * f + i1 * i1 - 4.0 * e2;
        const double slope = 4.0 * (f * f2 - i1 * f - 2.0 * j);
        if (!(slope > 0.0) || !(value > 0.0)) {
            break;
        }
        const double next = f - value / slope;
        if (!(next < f)) {
            break;
        }
        f = next;
    }
    return f;
}

/// Ascent of tr(R^T F) over rotations: Newton with the curvature made positive, so it never leaves for a saddle.
Mat3 climb(const Mat3& f, const Mat3& previous, double size) {
    Mat3 rotation = previous;
    constexpr int max_iterations = 30;
    for (int k = 0; k < max_iterations; ++k) {
        const Mat3 a = rotation.transpose() * f;
        const Vec3 gradient = skew_vector(a);
        const Mat3 curvature = a.trace() * Mat3::Identity() - 0.5 * (a + a.transpose());
        const SymmetricEigen3 eigen = symmetric_eigen(curvature);
        Vec3 step = eigen.vectors.transpose() * gradient;
        for (int i = 0; i < 3; ++i) {
            step[i] /= std::max(std::abs(eigen.values[i]), 1e-3 * size);
        }
        const double length = step.norm();
        if (!(length > 1e-15)) {
            break;
        }
        rotation = rotation * cayley(eigen.vectors * step * std::min(1.0, 0.5 / length));
    }
    return rotation;
}

}  // namespace

Mat3 cofactor(const Mat3& f) {
    Mat3 result;
    result.col(0) = f.col(1).cross(f.col(2));
    result.col(1) = f.col(2).cross(f.col(0));
    result.col(2) = f.col(0).cross(f.col(1));
    return result;
}

Mat3 cross_matrix(const Vec3& v) {
    Mat3 result;
    result << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return result;
}

Vec3 skew_vector(const Mat3& a) { return {a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1)}; }

Mat3 cayley(const Vec3& w) {
    const Quat q(1.0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z());
    return q.normalized().toRotationMatrix();
}

Mat3 spin_of_turn(const Vec3& z) { return (Mat3::Identity() + 0.5 * cross_matrix(z)) / (1.0 + 0.25 * z.squaredNorm()); }

Quat turn_of_z(const Vec3& direction) {
    const Vec3 d = direction.normalized();
    if (d.z() < -1.0 + 1e-12) {
        return Quat(0.0, 1.0, 0.0, 0.0);
    }
    const double s = std::sqrt(2.0 * (1.0 + d.z()));
    const Vec3 axis = Vec3::UnitZ().cross(d) * (1.0 / s);
    return Quat(0.5 * s, axis.x(), axis.y(), axis.z());
}

Quat turned(const Quat& rotation, const Vec3& w) {
    return (Quat(1.0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z()) * rotation).normalized();
}

Mat3 polar_rotation(const Mat3& f, const Mat3& previous) {
    const double i1 = f.squaredNorm();
    if (!(i1 > 0.0)) {
        return previous;
    }
    const Mat3 c = f.transpose() * f;
    const Mat3 cof = cofactor(f);
    // e2 as the sum of squared minors: the difference I^2 - C:C cancels for flat elements
    const double e2 = cof.squaredNorm();
    const double j = f.col(0).dot(cof.col(0));
    const double trace = trace_of_stretch(i1, e2, j);
    const double denominator = trace * (trace * trace - i1) - 2.0 * j;
    if (!(denominator > singular * i1 * std::sqrt(i1))) {
        return climb(f, previous, std::sqrt(i1));
    }
    return ((trace * trace + i1) * f - 2.0 * f * c + 2.0 * trace * cof) / denominator;
}

}  // namespace rhexis
