// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/opening_radii.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "math/turn.hpp"
#include "observe/opening.hpp"
#include "observe/rim.hpp"

namespace rhexis {
namespace {

double left_of(const Vec2& ray, const Vec2& place) { return ray.x() * place.y() - ray.y() * place.x(); }

/// Times that a ring goes round the axis, against the clock less with it: its crossings of the ray along +x.
int turns(const std::vector<Vec2>& ring) {
    int sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        const double side = left_of(b - a, -a);
        sum += a.y() <= 0.0 && b.y() > 0.0 && side > 0.0 ? 1 : 0;
        sum -= a.y() > 0.0 && b.y() <= 0.0 && side < 0.0 ? 1 : 0;
    }
    return sum;
}

/// The farthest place at which a ring crosses a ray from the axis.
double farthest_along(const Vec2& ray, const std::vector<Vec2>& ring) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        const double from = left_of(ray, a);
        const double to = left_of(ray, b);
        if ((from > 0.0) != (to > 0.0)) {
            farthest = std::max(farthest, ray.dot(a + from / (from - to) * (b - a)));
        }
    }
    return farthest;
}

std::string in_degrees(double angle) {
    return std::to_string(std::lround(angle * 180.0 / std::numbers::pi)).append(" degrees");
}

constexpr const char* round_opening = "a closed opening about the axis";

/// What keeps a bag from having this opening.
Status check_shape(const RhexisShape& shape) {
    if (!shape.opened) {
        return Error{"the anterior capsule is not open", "", round_opening};
    }
    if (shape.run_out) {
        return Error{"the tear has run out to the zonules", "", round_opening};
    }
    if (!shape.closed) {
        return Error{"the opening is not closed: its tear has come round by " + in_degrees(shape.turned), "",
                     round_opening};
    }
    return success();
}

}  // namespace

Result<std::vector<double>> ring_radii(const std::vector<Vec2>& ring, int count) {
    if (std::abs(turns(ring)) != 1) {
        return Error{"the opening does not go round the axis", "", round_opening};
    }
    std::vector<double> radii;
    for (int i = 0; i < count; ++i) {
        radii.push_back(farthest_along(direction_at(2.0 * std::numbers::pi * i / count), ring));
    }
    return radii;
}

Result<std::vector<double>> opening_radii(const MembraneModel& model, const MembraneState& state) {
    if (Status status = check_shape(rhexis_shape(*model.sheet, state, zonules_end(model))); !status) {
        return status.error();
    }
    std::vector<Vec2> ring;
    for (const Vec3& place : find_opening(*model.sheet, state).curve) {
        ring.emplace_back(place.head<2>());
    }
    return ring_radii(ring);
}

}  // namespace rhexis
