// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/split_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis::bench {
namespace {

double stiffness_weight(const MembraneModel& model, double dt) { return dt * (dt + model.damping_stiffness); }

bool moves(const MembraneModel& model, int node) {
    return !std::binary_search(model.fixed_nodes.begin(), model.fixed_nodes.end(), node);
}

/// b = dt f + M v - A v, nothing at nodes that do not move.
void set_right_side(const std::vector<double>& force, SplitSystem& system) {
    const std::size_t n = 3 * at(system.rows());
    std::vector<double> v(n, 0.0);
    for (std::size_t row = 0; row < at(system.rows()); ++row) {
        if (system.body.moves()[row] != 0) {
            Eigen::Map<Vec3>(v.data() + 3 * row) = system.state.velocity[at(system.body.node_of()[row])];
        }
    }
    system.b.assign(n, 0.0);
    system.matrix.multiply(v, system.b);
    for (std::size_t i = 0; i < n; ++i) {
        const double own = system.dt * force[i] + system.body.mass().inertia[i / 3] * v[i] - system.b[i];
        system.b[i] = system.body.moves()[i / 3] != 0 ? own : 0.0;
    }
}

}  // namespace

SplitSystem assemble(const MembraneModel& model, const MembraneState& state, MembraneBody& body, double dt) {
    SplitSystem system{model, state, body, dt, CoupledMatrix(body.pattern(), *linear_kernel::choose()), {}};
    std::vector<double> x(3 * at(body.rows()) + 1, 0.0);
    for (std::size_t row = 0; row < at(body.rows()); ++row) {
        Eigen::Map<Vec3>(x.data() + 3 * row) = state.position[at(body.node_of()[row])];
    }
    std::vector<double> force;
    body.forces_and_stiffness(x, elastic_kernel::Mode::warped, stiffness_weight(model, dt), force,
                              system.matrix.solid());
    const double inertia = 1.0 + dt * model.damping_mass;
    for (int row = 0; row < body.rows(); ++row) {
        const double mass = body.moves()[at(row)] != 0 ? inertia * body.mass().inertia[at(row)] : 1.0;
        add_block(system.matrix.solid(), body.pattern().diagonal[at(row)], mass * Mat3::Identity());
    }
    mirror_upper(body.pattern(), system.matrix.solid());
    system.matrix.clear_coupling(0);
    set_right_side(force, system);
    return system;
}

double true_residual(const SplitSystem& system, const std::vector<double>& x) {
    std::vector<double> image(x.size(), 0.0);
    system.matrix.multiply(x, image);
    double off = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        off += (system.b[i] - image[i]) * (system.b[i] - image[i]);
        size += system.b[i] * system.b[i];
    }
    return std::sqrt(off / size);
}

Mat9 triangle_share(const MembraneModel& model, const MembraneState& state, int triangle, double dt) {
    const MembraneTriangle own =
        membrane_triangle(model, *state.sheet, triangle, frame_of(state.sheet->mesh, triangle));
    TrianglePoints force;
    TriangleBlocks blocks;
    membrane_stiffness(own, points_now(state, triangle), MembraneTangent::definite, force, blocks);
    const std::array<int, 3>& node = state.sheet->mesh.triangles[at(triangle)];
    const double mass = (1.0 + dt * model.damping_mass) * model.density * own.volume / 3.0;
    Mat9 result = Mat9::Zero();
    std::size_t pair = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b, ++pair) {
            if (!moves(model, node[at(a)]) || !moves(model, node[at(b)])) {
                continue;
            }
            Mat3 block = stiffness_weight(model, dt) * blocks[pair];
            if (a == b) {
                block += mass * Mat3::Identity();
            }
            result.block<3, 3>(3 * a, 3 * b) = block;
            result.block<3, 3>(3 * b, 3 * a) = block.transpose();
        }
    }
    return result;
}

}  // namespace rhexis::bench
