// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/tissue_near.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/places.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {

namespace {

/// A ball around a tip and all that lies within reach of it.
struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
};

Ball ball_around(const RoundedCone& end, const Pose& pose, double reach) {
    const double half = 0.5 * (end.b - end.a).norm();
    return {pose.to_world(0.5 * (end.a + end.b)), half + std::max(end.radius_a, end.radius_b) + reach};
}

/// Bounding ball of a coarse tetrahedron against the tip: skips nearly all of the body. Most of it is skipped by the
/// ball around the tip already, without looking at its shape.
bool out_of_reach(const RoundedCone& end, const Ball& around, const Pose& pose, double reach,
                  const std::vector<Vec3>& x, const std::array<int, 4>& tet) {
    constexpr double spare = 1e-6;  // for rounding [mm]
    const Vec3 centre = centroid(x, tet);
    double square = 0.0;
    for (int node : tet) {
        square = std::max(square, (x[node] - centre).squaredNorm());
    }
    const double radius = std::sqrt(square);
    const double apart = around.radius + radius + spare;
    return (centre - around.centre).squaredNorm() > apart * apart ||
           cone_distance(end, pose.to_body(centre)).distance > reach + radius;
}

/// Points outside of the box around a tetrahedron need no closer look.
bool outside_box(const std::array<Vec3, 4>& corners, const Vec3& point) {
    for (Eigen::Index k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k], corners[3][k]});
        if (point[k] < low || point[k] > high) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<FineTissue> tissue_near(const SolidModel& model, const SolidState& state, const RoundedCone& end,
                                    const Pose& pose, double reach) {
    std::vector<FineTissue> near;
    const std::vector<Vec3>& x = state.position;
    const Ball around = ball_around(end, pose, reach);
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        if (state.present[t] == 0 || out_of_reach(end, around, pose, reach, x, model.coarse.tets[t])) {
            continue;
        }
        for (std::size_t f = 8 * t; f < 8 * t + 8; ++f) {
            if (!(state.fraction[f] > 0.0)) {
                continue;
            }
            FineTissue tissue;
            tissue.tet = static_cast<int>(f);
            for (std::size_t k = 0; k < 4; ++k) {
                tissue.corners[k] = fine_point(model.fine, x, model.fine.tets[f][k]);
            }
            near.push_back(tissue);
        }
    }
    return near;
}

bool holds(const std::array<Vec3, 4>& corners, const Vec3& point) {
    if (outside_box(corners, point)) {
        return false;
    }
    const double whole = tet_volume(corners[0], corners[1], corners[2], corners[3]);
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vec3, 4> part = corners;
        part[k] = point;
        if (tet_volume(part[0], part[1], part[2], part[3]) * whole < 0.0) {
            return false;
        }
    }
    return true;
}

}  // namespace rhexis
