// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/material_points.hpp"
#include "mesh/places.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {

namespace {

constexpr double point_share = 0.5;   ///< radius of the ball of a point, as a share of the edge of a cube of its volume
constexpr double most_coming = 0.5;   ///< of tissue towards a tool in a step; a faster node is a loose one [mm]
constexpr double points_each = 32.0;  ///< of a coarse tetrahedron

/// A coarse tetrahedron as a ball.
struct Bound {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    double coming = 0.0;  ///< how far it may move in the step [mm]
};

Bound bound_of(const SolidState& state, const std::array<int, 4>& tet, double dt) {
    Bound bound;
    bound.centre = centroid(state.position, tet);
    double square = 0.0;
    double pace = 0.0;
    for (const int node : tet) {
        square = std::max(square, (state.position[node] - bound.centre).squaredNorm());
        pace = std::max(pace, state.velocity[node].squaredNorm());
    }
    bound.radius = std::sqrt(square);
    bound.coming = std::min(most_coming, dt * std::sqrt(pace));
    return bound;
}

/// The tools that come near a tetrahedron.
void tools_at(const Bound& bound, double spacing, std::span<const ToolReach> reaches, std::vector<int>& near) {
    near.clear();
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const ToolReach& reach = reaches[i];
        const double far = bound.radius + bound.coming + reach.margin + spacing;
        const Vec3 local = reach.pose.to_body(bound.centre);
        if (tool_distance(*reach.tool, local, 0.0).distance < far) {
            near.push_back(static_cast<int>(i));
        }
    }
}

/// A point with its nodes by what they bear, most first.
ContactPoint make_point(int id, const std::array<int, 4>& tet, const std::array<double, 4>& weights, double spacing,
                        double modulus) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
    ContactPoint point;
    point.id = id;
    for (std::size_t k = 0; k < 4; ++k) {
        point.nodes[k] = tet[order[k]];
        point.weights[k] = weights[order[k]];
    }
    point.size = spacing;
    point.radius = point_share * spacing;
    point.stiffness = modulus * spacing;
    return point;
}

}  // namespace

void find_near_points(const SolidModel& model, const SolidState& state, std::span<const ToolReach> reaches, double dt,
                      std::vector<NearPoint>& points) {
    points.clear();
    const int first_id = static_cast<int>(model.coarse.nodes.size() + model.fine.edges.size());
    std::vector<int> near;
    for (int t = 0; t < static_cast<int>(model.coarse.tets.size()); ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const Material& material = model.materials[model.coarse.region[t]];
        const double spacing = std::cbrt(tet_mass(model, t) / (points_each * material.density));
        const Bound bound = bound_of(state, tet, dt);
        tools_at(bound, spacing, reaches, near);
        for (int fine = 8 * t; fine < 8 * t + 8 && !near.empty(); ++fine) {
            if (!(state.fraction[fine] > 0.0)) {
                continue;
            }
            const PointWeights weights = material_points(model.coarse, model.fine, fine);
            const std::array<double, 4> left = left_of_points(state, fine);
            for (std::size_t p = 0; p < 4; ++p) {
                if (!(left[p] > still_there)) {
                    continue;
                }
                const int id = first_id + 4 * fine + static_cast<int>(p);
                const ContactPoint point = make_point(id, tet, weights[p], spacing, material.young_modulus);
                const Vec3 place = point_of(point, state.position);
                for (const int i : near) {
                    const ToolReach& reach = reaches[static_cast<std::size_t>(i)];
                    const double gap =
                        tool_distance(*reach.tool, reach.pose.to_body(place), resolved_by_points * spacing).distance -
                        point.radius;
                    if (gap < reach.margin + bound.coming) {
                        points.push_back({point, i});
                    }
                }
            }
        }
    }
}

}  // namespace rhexis
