// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/capsule.hpp"

namespace rhexis {

bool within_hole(const CapsuleState& capsule, const Vec3& local) {
    return capsule.hole_radius > 0.0 && local.z() < 0.0 &&
           (local - capsule.hole_place).squaredNorm() < capsule.hole_radius * capsule.hole_radius;
}

}  // namespace rhexis
