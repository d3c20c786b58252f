// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/corotational.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/rotation.hpp"
#include "math/symmetric_eigen.hpp"

namespace rhexis {
namespace {

/// H in the rest frame: max(c / g_i, least) about each principal axis.
Mat3 twist_modes(const Mat3& g, double c, double least) {
    const SymmetricEigen3 eigen = symmetric_eigen(g);
    // s_j + s_k >= 0 by choice of R; the floor keeps the singular set finite
    const double floor = 1e-6 * eigen.values.cwiseAbs().maxCoeff() + 1e-300;
    Vec3 h;
    for (int i = 0; i < 3; ++i) {
        h[i] = std::max(c / std::max(eigen.values[i], floor), least);
    }
    return eigen.vectors * h.asDiagonal() * eigen.vectors.transpose();
}

}  // namespace

Lame lame(double young_modulus, double poisson_ratio) {
    RHEXIS_ASSERT(young_modulus >= 0.0 && poisson_ratio >= 0.0 && poisson_ratio < 0.5);
    return {young_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
            young_modulus / (2.0 * (1.0 + poisson_ratio))};
}

CorotationalPoint corotational_point(const Mat3& gradient, const Mat3& previous) {
    CorotationalPoint point;
    point.gradient = gradient;
    point.rotation = polar_rotation(gradient, previous);
    point.trace = point.rotation.cwiseProduct(gradient).sum();
    return point;
}

double corotational_energy(const CorotationalPoint& point, const Lame& material) {
    const double dilation = point.trace - 3.0;
    return material.mu * (point.gradient - point.rotation).squaredNorm() + 0.5 * material.lambda * dilation * dilation;
}

Mat3 corotational_stress(const CorotationalPoint& point, const Lame& material) {
    return 2.0 * material.mu * (point.gradient - point.rotation) +
           material.lambda * (point.trace - 3.0) * point.rotation;
}

Mat3 CorotationalTangent::stress_change(const Mat3& change) const {
    const Vec3 turn = skew_vector(change * rotation.transpose());
    return 2.0 * material.mu * change + material.lambda * rotation.cwiseProduct(change).sum() * rotation +
           cross_matrix(twist * turn) * rotation;
}

Mat3 CorotationalTangent::block(const Vec3& a, const Vec3& b) const {
    const Vec3 ga = rotation * a;
    const Vec3 gb = rotation * b;
    Mat3 result = material.lambda * ga * gb.transpose() - cross_matrix(ga) * twist * cross_matrix(gb);
    result.diagonal().array() += 2.0 * material.mu * a.dot(b);
    return result;
}

CorotationalTangent corotational_tangent(const CorotationalPoint& point, const Lame& material, Tangent kind) {
    CorotationalTangent tangent;
    tangent.rotation = point.rotation;
    tangent.material = material;
    if (kind == Tangent::warped) {
        tangent.twist = -material.mu * Mat3::Identity();
        return tangent;
    }
    const Mat3 a = point.rotation.transpose() * point.gradient;
    const Mat3 g = point.trace * Mat3::Identity() - 0.5 * (a + a.transpose());
    const double c = material.lambda * (point.trace - 3.0) - 2.0 * material.mu;
    const double least = kind == Tangent::projected ? -material.mu : -HUGE_VAL;
    const Mat3 modes = twist_modes(g, c, least);
    tangent.twist = point.rotation * modes * point.rotation.transpose();
    return tangent;
}

}  // namespace rhexis
