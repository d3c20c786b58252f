// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/material_points.hpp"
#include "mesh/places.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {

namespace {

constexpr double point_share = 0.5;  ///< radius of the ball of a point, as a share of the edge of a cube of its volume
constexpr double rounding = 1e-9;    ///< [mm]
constexpr double most_coming = 0.5;  ///< of tissue towards a tool in a step; a faster node is a loose one [mm]

/// What a tool's parts take up at the start of the step.
Box box_of(const ToolReach& reach) {
    Box box;
    for (const RoundedCone& part : reach.tool->parts) {
        box.add(reach.pose.to_world(part.a), part.radius_a);
        box.add(reach.pose.to_world(part.b), part.radius_b);
    }
    return box;
}

struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
};

/// A coarse tetrahedron as a ball.
struct Bound : Ball {
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

/// What comes into question within a ball, its centre in the tool's frame.
double margin_at(const ToolReach& reach, const Vec3& local, double radius) {
    const double far = reach.mouth_radius + radius;
    const bool sucked = reach.mouth_radius > 0.0 && (local - reach.mouth).squaredNorm() < far * far;
    return sucked ? reach.mouth_margin : reach.margin;
}

/// The tools that come near a tetrahedron.
void tools_at(const Bound& bound, double spacing, std::span<const ToolReach> reaches, std::span<const Box> boxes,
              std::vector<int>& near) {
    near.clear();
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const ToolReach& reach = reaches[i];
        const Vec3 local = reach.pose.to_body(bound.centre);
        const double far = bound.radius + bound.coming + margin_at(reach, local, bound.radius) + spacing;
        if (square_to(boxes[i], bound.centre) < far * far && tool_distance(*reach.tool, local, 0.0).distance < far) {
            near.push_back(static_cast<int>(i));
        }
    }
}

/// What a fine tetrahedron takes up, and all its points with it.
Ball ball_of(const SolidModel& model, const SolidState& state, int fine) {
    std::array<Vec3, 4> corners;
    std::transform(model.fine.tets[fine].begin(), model.fine.tets[fine].end(), corners.begin(),
                   [&](int node) { return fine_point(model.fine, state.position, node); });
    Ball ball;
    ball.centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    double square = 0.0;
    for (const Vec3& corner : corners) {
        square = std::max(square, (corner - ball.centre).squaredNorm());
    }
    ball.radius = std::sqrt(square);
    return ball;
}

/// Those of the tools that may meet a point within a ball.
void keep_near(const Ball& ball, double spacing, double coming, std::span<const ToolReach> reaches,
               const std::vector<int>& near, std::vector<int>& close) {
    close.clear();
    for (const int i : near) {
        const ToolReach& reach = reaches[static_cast<std::size_t>(i)];
        const Vec3 local = reach.pose.to_body(ball.centre);
        const double far =
            ball.radius + point_share * spacing + coming + margin_at(reach, local, ball.radius) + rounding;
        if (tool_distance(*reach.tool, local, resolved_by_points * spacing).distance < far) {
            close.push_back(i);
        }
    }
}

/// A point with its nodes by what they bear, most first.
ContactPoint make_point(int id, const std::array<int, 4>& tet, const std::array<double, 4>& weights, double spacing,
                        double modulus) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (std::size_t last = 1; last < 4; ++last) {  // four are too few for a sort that asks for memory
        for (std::size_t k = last; k > 0 && weights[order[k]] > weights[order[k - 1]]; --k) {
            std::swap(order[k], order[k - 1]);
        }
    }
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

void find_near_points(const SolidModel& model, const std::vector<double>& spacings, const SolidState& state,
                      std::span<const ToolReach> reaches, double dt, std::vector<NearPoint>& points) {
    points.clear();
    std::vector<Box> boxes(reaches.size());
    std::transform(reaches.begin(), reaches.end(), boxes.begin(), box_of);
    const int first_id = static_cast<int>(model.coarse.nodes.size() + model.fine.edges.size());
    std::vector<int> near;   // tools that come near the coarse tetrahedron
    std::vector<int> close;  // those of them that come near the fine one
    for (int t = 0; t < static_cast<int>(model.coarse.tets.size()); ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const double modulus = model.materials[model.coarse.region[t]].young_modulus;
        const double spacing = spacings[static_cast<std::size_t>(t)];
        const Bound bound = bound_of(state, tet, dt);
        tools_at(bound, spacing, reaches, boxes, near);
        for (int fine = 8 * t; fine < 8 * t + 8 && !near.empty(); ++fine) {
            if (!(state.fraction[fine] > 0.0)) {
                continue;
            }
            keep_near(ball_of(model, state, fine), spacing, bound.coming, reaches, near, close);
            if (close.empty()) {
                continue;
            }
            const PointWeights weights = material_points(model.coarse, model.fine, fine);
            const std::array<double, 4> left = left_of_points(state, fine);
            for (std::size_t p = 0; p < 4; ++p) {
                if (!(left[p] > still_there)) {
                    continue;
                }
                const int id = first_id + 4 * fine + static_cast<int>(p);
                const ContactPoint point = make_point(id, tet, weights[p], spacing, modulus);
                const Vec3 place = point_of(point, state.position);
                for (const int i : close) {
                    const ToolReach& reach = reaches[static_cast<std::size_t>(i)];
                    const Vec3 local = reach.pose.to_body(place);
                    const double gap =
                        tool_distance(*reach.tool, local, resolved_by_points * spacing).distance - point.radius;
                    if (gap < margin_at(reach, local, 0.0) + bound.coming) {
                        points.push_back({point, i});
                    }
                }
            }
        }
    }
}

}  // namespace rhexis
