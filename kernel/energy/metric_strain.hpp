// SPDX-License-Identifier: GPL-3.0-or-later
// Strain of a surface from its metric C = F^T F (F: 3x2, rest frame to space): the symmetric part of the polar
// decomposition F = R U, less the identity, without R. Hence the same whatever frame is taken, in the plane or in
// space.
//
//   U = (C + d I) / t,  d = sqrt(det C),  t = sqrt(tr C + 2 d)                                        [Hoger1984]
//
// Metric as (c11, c22, c12), strain as (e11, e22, 2 e12). d is rounded off near 0, so that a triangle crushed to a line
// keeps finite derivatives; at rest nothing is changed by that.
#pragma once

#include <array>

#include "math/types.hpp"

namespace rhexis {

struct MetricStrain {
    Vec3 strain = Vec3::Zero();
    Mat3 first = Mat3::Zero();                                             ///< row k: d strain[k] / d metric
    std::array<Mat3, 3> second{Mat3::Zero(), Mat3::Zero(), Mat3::Zero()};  ///< of each strain, symmetric
};

/// Value and first derivative.
void metric_strain(const Vec3& metric, MetricStrain& result);
/// All three.
void metric_strain_twice(const Vec3& metric, MetricStrain& result);

}  // namespace rhexis
