// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/metric_strain.hpp"

#include <cmath>

namespace rhexis {
namespace {

constexpr double roundness = 1e-3;  // of the area ratio near 0

/// d and t of the header with their derivatives by the metric.
struct Roots {
    double d = 0.0;
    double t = 0.0;
    Vec3 d1 = Vec3::Zero();
    Vec3 t1 = Vec3::Zero();
    double root = 0.0;          ///< d before it is shifted to be 1 at rest
    Vec3 minor = Vec3::Zero();  ///< d det C / d metric
    static constexpr double corner = roundness * roundness;
};

Roots roots_of(const Vec3& c) {
    Roots r;
    const double det = c[0] * c[1] - c[2] * c[2];
    r.root = std::sqrt(std::max(det, 0.0) + Roots::corner);
    r.d = r.root - (std::sqrt(1.0 + Roots::corner) - 1.0);
    r.t = std::sqrt(c[0] + c[1] + 2.0 * r.d);
    r.minor = Vec3(c[1], c[0], -2.0 * c[2]);
    r.d1 = r.minor / (2.0 * r.root);
    r.t1 = (Vec3(1.0, 1.0, 0.0) + 2.0 * r.d1) / (2.0 * r.t);
    return r;
}

/// Strain is (n / t - rest) with n linear in C and d.
struct Part {
    double n;
    Vec3 n1;
    double by_d;  ///< d^2 n / d metric^2 = by_d times that of d
    double rest;
};

std::array<Part, 3> parts_of(const Vec3& c, const Roots& r) {
    return {{{c[0] + r.d, Vec3(1.0, 0.0, 0.0) + r.d1, 1.0, 1.0},
             {c[1] + r.d, Vec3(0.0, 1.0, 0.0) + r.d1, 1.0, 1.0},
             {2.0 * c[2], Vec3(0.0, 0.0, 2.0), 0.0, 0.0}}};
}

void fill_first(const std::array<Part, 3>& parts, const Roots& r, MetricStrain& result) {
    for (int k = 0; k < 3; ++k) {
        const Part& p = parts[static_cast<std::size_t>(k)];
        result.strain[k] = p.n / r.t - p.rest;
        result.first.row(k) = ((p.n1 - (p.n / r.t) * r.t1) / r.t).transpose();
    }
}

}  // namespace

void metric_strain(const Vec3& metric, MetricStrain& result) {
    const Roots r = roots_of(metric);
    fill_first(parts_of(metric, r), r, result);
}

void metric_strain_twice(const Vec3& metric, MetricStrain& result) {
    const Roots r = roots_of(metric);
    const std::array<Part, 3> parts = parts_of(metric, r);
    fill_first(parts, r, result);
    Mat3 minor2 = Mat3::Zero();  // second derivative of det C
    minor2(0, 1) = minor2(1, 0) = 1.0;
    minor2(2, 2) = -2.0;
    const Mat3 d2 = minor2 / (2.0 * r.root) - r.minor * r.minor.transpose() / (4.0 * r.root * r.root * r.root);
    const Mat3 t2 = (d2 - r.t1 * r.t1.transpose()) / r.t;
    const double t_2 = 1.0 / (r.t * r.t);
    const Mat3 twice = 2.0 * r.t1 * r.t1.transpose() / r.t - t2;
    for (std::size_t k = 0; k < 3; ++k) {
        const Part& p = parts[k];
        result.second[k] =
            p.by_d * d2 / r.t - t_2 * (p.n1 * r.t1.transpose() + r.t1 * p.n1.transpose()) + (p.n * t_2) * twice;
    }
}

}  // namespace rhexis
