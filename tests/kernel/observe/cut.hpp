// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet that is torn along lines that are known, edge by edge.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/index.hpp"
#include "mesh/shapes.hpp"
#include "observe/rim.hpp"
#include "scenes/membranes.hpp"
#include "topology/tear.hpp"

namespace rhexis::test {

using namespace rhexis::scenes;

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180.0;

/// Where a tear is to go: a place by an angle [rad], as seen from above.
using Line = std::function<Vec2(double)>;

inline Line ellipse(double a, double b, const Vec2& centre = Vec2::Zero()) {
    return [=](double angle) { return Vec2(centre.x() + a * std::cos(angle), centre.y() + b * std::sin(angle)); };
}
inline Line circle(double radius, const Vec2& centre = Vec2::Zero()) { return ellipse(radius, radius, centre); }

inline TriMesh centred_square(int triangles) {
    TriMesh mesh = square_sheet(10.0, triangles);
    for (Vec3& x : mesh.nodes) {
        x -= Vec3(5.0, 5.0, 0.0);
    }
    return mesh;
}
inline TriMesh jittered_round(int triangles) { return jittered(round_sheet(5.0, triangles), 0.2, 3); }

/// The front of a lens: how much lower it is than at the axis [mm].
inline double height(const Vec2& place, double radius) {
    return std::sqrt(radius * radius - place.squaredNorm()) - radius;
}

/// A flat sheet laid on the front of a lens.
inline TriMesh domed(TriMesh mesh, double radius) {
    for (Vec3& x : mesh.nodes) {
        x.z() = height(x.head<2>(), radius);
    }
    return mesh;
}

/// A sheet and a knife whose tip is the leading one.
struct Cut {
    MembraneModel model;
    MembraneState state;
    double dome = HUGE_VAL;  ///< radius of the front that it lies on [mm]

    explicit Cut(const TriMesh& mesh)
        : model(membrane("anterior_capsule", mesh, {1.0e6, 1.0e6, 0.45, 0.0})), state(rest_state(model)) {}

    [[nodiscard]] RhexisShape shape() const { return rhexis_shape(*model.sheet, state); }
    [[nodiscard]] double edge() const { return mean_edge(model.sheet->mesh); }
    [[nodiscard]] const Vec3& node(int n) const { return state.sheet->mesh.nodes[at(n)]; }
    [[nodiscard]] Vec2 place(const TearTip& tip) const { return node(tip.node).head<2>(); }
    [[nodiscard]] int parts() const {
        const std::vector<int> parts = sheet_parts(state.sheet->neighbours);
        return 1 + *std::max_element(parts.begin(), parts.end());
    }

    void carry(const Result<MembraneEdit>& edit) {
        REQUIRE(edit.ok());
        state = applied(state, edit.value());
    }

    [[nodiscard]] int nearest_node(const Vec2& to, const std::vector<int>& among) const {
        return *std::min_element(among.begin(), among.end(), [&](int a, int b) {
            return (node(a).head<2>() - to).norm() < (node(b).head<2>() - to).norm();
        });
    }

    /// Of the sheet before anything was torn.
    [[nodiscard]] int nearest_to(const Vec2& to) const {
        std::vector<int> all(model.sheet->mesh.nodes.size());
        std::iota(all.begin(), all.end(), 0);
        return nearest_node(to, all);
    }

    /// Opens the capsule at the node nearest to a place; the leading tip is the one ahead.
    void puncture_at(const Vec2& where, const Vec2& ahead) {
        const TriNeighbours& around = state.sheet->neighbours;
        std::vector<int> all(state.sheet->mesh.nodes.size());
        std::iota(all.begin(), all.end(), 0);
        const int n = nearest_node(where, all);
        const int triangle = around.triangles[at(around.offset[at(n)])];
        carry(puncture(model, state, triangle, node(n), Vec3(-ahead.x(), -ahead.y(), 0.0)));
    }

    /// One edge on, to a place. What the tip is owed is what the tear adds by itself.
    void go_to(const Vec2& to) {
        const Vec3 here = node(state.tips.back().node) + state.tips.back().owed;
        const Vec3 there(to.x(), to.y(), std::isfinite(dome) ? height(to, dome) : 0.0);
        carry(tear(model, state, static_cast<int>(state.tips.size()) - 1, there - here));
    }

    /// Counter-clockwise along a line from one angle to another, or until the tear has met its beginning.
    void go_along(const Line& line, double from, double to) {
        const std::size_t tips = state.tips.size();
        double angle = from;
        while (state.tips.size() == tips && angle < to) {
            const Vec2 here = state.tips.back().owed.head<2>() + place(state.tips.back());
            while ((line(angle + 0.01) - here).norm() < std::max(edge(), (line(angle) - here).norm())) {
                angle += 0.01;
            }
            const Vec2 beginning = place(state.tips.front());
            const bool home = angle > from + pi && (beginning - here).norm() < 1.5 * edge();
            go_to(home ? beginning : line(angle));
        }
    }

    /// The angle at which a node lies closest to a line.
    [[nodiscard]] double best_start(const Line& line) const {
        double best = 0.0;
        double least = HUGE_VAL;
        for (double angle = 0.0; angle < 2.0 * pi; angle += 0.01) {
            for (const Vec3& x : model.sheet->mesh.nodes) {
                const double distance = (x.head<2>() - line(angle)).norm();
                best = distance < least ? angle : best;
                least = std::min(least, distance);
            }
        }
        return best;
    }

    /// Along a line, by an angle; all the way round without one.
    void cut_along(const Line& line, double sweep = 3.0 * pi) {
        const double start = best_start(line);
        puncture_at(line(start), line(start + 0.01) - line(start - 0.01));
        go_along(line, start, start + sweep);
    }

    /// Begins a tear at an edge of the sheet. Where two pieces lie on each other only one of them lies ahead.
    void notch_at(const Vec2& where, const Vec2& ahead) {
        std::vector<int> edges;
        for (const std::vector<int>& loop : boundary_loops(state.sheet->mesh, state.sheet->neighbours)) {
            edges.insert(edges.end(), loop.begin(), loop.end());
        }
        const Vec3 nearest = node(nearest_node(where, edges));
        for (const int n : edges) {
            const Result<MembraneEdit> edit = notch(model, state, n, Vec3(ahead.x(), ahead.y(), 0.0));
            if (node(n) == nearest && edit.ok()) {
                state = applied(state, edit.value());
                return;
            }
        }
        FAIL("nothing to tear there");
    }

    /// Straight on, while the tip is nearer than that to the axis and has not run out.
    void go_out(const Vec2& ahead, double radius) {
        const std::size_t tips = state.tips.size();
        while (state.tips.size() == tips && place(state.tips.back()).norm() < radius) {
            go_to(place(state.tips.back()) + 5.0 * ahead);
        }
    }
};

}  // namespace rhexis::test
