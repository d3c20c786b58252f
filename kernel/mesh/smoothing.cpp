// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/smoothing.hpp"

#include <limits>

#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

/// With k^3 = (sum of squared edges / 6)^3 / (6 sqrt(2) volume)^2, which is 1 for the regular tetrahedron, the energy
/// is k^6 / (6 volume)^2. The last factor favours equal volumes: the smallest elements set the explicit step, and it
/// makes that a quarter longer. Only products and divisions, so the same bits everywhere.
struct Shape {
    double energy = 0.0;
    Vec3 gradient = Vec3::Zero();
    double curvature = 0.0;  ///< of the part that grows with edge lengths: a scale for the step
};

class Smoother {
public:
    Smoother(const HalfEllipsoids& shape, StuffedSolid& solid)
        : shape_(shape),
          solid_(solid),
          around_(node_tets(solid.mesh.tets, static_cast<int>(solid.mesh.nodes.size()))) {}

    void sweep() {
        for (std::size_t n = 0; n < solid_.mesh.nodes.size(); ++n) {
            improve(n);
        }
    }

private:
    /// Of tetrahedron t as a function of the place of node n.
    [[nodiscard]] Shape tet_shape(int t, std::size_t n, bool with_gradient) const {
        const std::array<int, 4>& tet = solid_.mesh.tets[static_cast<std::size_t>(t)];
        std::size_t local = 0;
        while (static_cast<std::size_t>(tet[local]) != n) {
            ++local;
        }
        const Vec3& x = solid_.mesh.nodes[n];
        std::array<const Vec3*, 3> face{};
        for (std::size_t i = 0; i < 3; ++i) {
            face[i] = &solid_.mesh.nodes[static_cast<std::size_t>(tet[static_cast<std::size_t>(tet_faces[local][i])])];
        }
        const Vec3 inward = (*face[2] - *face[0]).cross(*face[1] - *face[0]);
        const double six_volumes = inward.dot(x - *face[0]);
        if (six_volumes <= 0.0) {
            return {std::numeric_limits<double>::infinity(), Vec3::Zero(), 0.0};
        }
        const Vec3 sum = 3.0 * x - *face[0] - *face[1] - *face[2];
        const double edges = (x - *face[0]).squaredNorm() + (x - *face[1]).squaredNorm() +
                             (x - *face[2]).squaredNorm() + (*face[0] - *face[1]).squaredNorm() +
                             (*face[1] - *face[2]).squaredNorm() + (*face[2] - *face[0]).squaredNorm();
        const double mean = edges / 6.0;
        const double k3 = mean * mean * mean / (2.0 * six_volumes * six_volumes);
        Shape result;
        result.energy = k3 * k3 / (six_volumes * six_volumes);
        if (with_gradient) {
            result.gradient = result.energy * (12.0 / edges * sum - 6.0 / six_volumes * inward);
            result.curvature = result.energy * 36.0 / edges;
        }
        return result;
    }

    [[nodiscard]] Shape shape_around(std::size_t n, bool with_gradient) const {
        Shape total;
        for (int i = around_.offset[n]; i < around_.offset[n + 1]; ++i) {
            const Shape one = tet_shape(around_.tets[static_cast<std::size_t>(i)], n, with_gradient);
            total.energy += one.energy;
            total.gradient += one.gradient;
            total.curvature += one.curvature;
        }
        return total;
    }

    void improve(std::size_t n) {
        Vec3& x = solid_.mesh.nodes[n];
        const Vec3 start = x;
        const Shape before = shape_around(n, true);
        Vec3 step = -before.gradient / before.curvature;
        if (solid_.on_surface[n] != 0) {
            const Vec3 normal = closest_on(shape_, x).normal;
            step -= normal.dot(step) * normal;
        }
        for (int halving = 0; halving < 5; ++halving, step *= 0.5) {
            x = start + step;
            if (solid_.on_surface[n] != 0) {
                x = onto_surface(shape_, x);
            }
            if (shape_around(n, false).energy < before.energy) {
                return;
            }
        }
        x = start;
    }

    const HalfEllipsoids& shape_;
    StuffedSolid& solid_;
    NodeTets around_;
};

}  // namespace

void smooth(const HalfEllipsoids& shape, int sweeps, StuffedSolid& solid) {
    Smoother smoother(shape, solid);
    for (int i = 0; i < sweeps; ++i) {
        smoother.sweep();
    }
}

}  // namespace rhexis
