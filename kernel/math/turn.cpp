// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/turn.hpp"

#include <cmath>

namespace rhexis {

Vec2 direction_at(double angle) {
    const double x = angle / 64.0;
    const double tangent = x * (15.0 - x * x) / (15.0 - 6.0 * x * x);
    Vec2 d = Vec2(1.0, tangent).normalized();
    for (int doubling = 0; doubling < 6; ++doubling) {
        d = Vec2(d.x() * d.x() - d.y() * d.y(), 2.0 * d.x() * d.y());
    }
    return d.normalized();
}

double share_of_turn(const Vec3& place) {
    const double sum = std::abs(place.x()) + std::abs(place.y());
    const double quarter = sum > 0.0 ? place.y() / sum : 0.0;
    return 0.25 * (place.x() < 0.0 ? 2.0 - quarter : (place.y() < 0.0 ? 4.0 + quarter : quarter));
}

}  // namespace rhexis
