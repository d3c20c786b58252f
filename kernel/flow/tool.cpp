// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/tool.hpp"

#include <cmath>

namespace rhexis {

namespace {

/// By its power series: the library's may differ in its last bit between processors. angle in [0, 1.2].
double tangent_of(double angle) {
    double sine = 0.0;
    double cosine = 0.0;
    double term = 1.0;
    for (int n = 0; n < 24; ++n) {
        (n % 2 == 0 ? cosine : sine) += (n / 2) % 2 == 0 ? term : -term;
        term *= angle / (n + 1);
    }
    return sine / cosine;
}

}  // namespace

Mouth tip_mouth(const ToolModel& tool) {
    const RoundedCone& end = tool.parts.front();
    if (tool.kind == ToolKind::aspirator) {
        return {end.a + Vec3(0.0, end.radius_a, 0.0), Vec3::UnitY()};
    }
    const double tangent = tangent_of(tool.bevel);
    return {end.a + Vec3(0.0, 0.0, end.radius_a * (tangent - 1.0)), Vec3(0.0, tangent, -1.0).normalized()};
}

}  // namespace rhexis
