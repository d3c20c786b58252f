// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/tool.hpp"

#include <cmath>

namespace rhexis {

Mouth tip_mouth(const ToolModel& tool) {
    const RoundedCone& end = tool.parts.front();
    const double tangent = tangent_of(tool.bevel);
    return {end.a + Vec3(0.0, 0.0, end.radius_a * (tangent - 1.0)), Vec3(0.0, tangent, -1.0).normalized()};
}

}  // namespace rhexis
