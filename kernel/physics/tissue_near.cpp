// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/tissue_near.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/places.hpp"
#include "physics/tool_shape.hpp"

namespace rhexis {

namespace {

/// Bounding ball of a coarse tetrahedron against the tip: skips nearly all of the body.
bool out_of_reach(const RoundedCone& end, const Pose& pose, double reach, const std::vector<Vec3>& x,
                  const std::array<int, 4>& tet) {
    const Vec3 centre = centroid(x, tet);
    double radius = 0.0;
    for (int node : tet) {
        radius = std::max(radius, (x[node] - centre).squaredNorm());
    }
    return cone_distance(end, pose.to_body(centre)).distance > reach + std::sqrt(radius);
}

}  // namespace

std::vector<FineTissue> tissue_near(const SolidModel& model, const SolidState& state, const RoundedCone& end,
                                    const Pose& pose, double reach) {
    std::vector<FineTissue> near;
    const std::vector<Vec3>& x = state.position;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        if (state.present[t] == 0 || out_of_reach(end, pose, reach, x, model.coarse.tets[t])) {
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
