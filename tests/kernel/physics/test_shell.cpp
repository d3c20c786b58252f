// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "energy/shell_triangle.hpp"
#include "math/rotation.hpp"
#include "physics/shell_body.hpp"
#include "physics/shell_statics.hpp"
#include "physics/shell_stepper.hpp"
#include "scenes/shell_problems.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A curved sheet of varying thickness.
ShellModel sample() {
    const auto map = [](double s, double t) { return Vec3(2.0 * s, 1.5 * t + 0.2 * s, 0.5 * s * s - 0.3 * s * t); };
    ShellModel model = uniform_shell("sample", scenes::grid_mesh(4, 3, scenes::GridCut::alternate, map), 0.1);
    for (std::size_t t = 0; t < model.thickness.size(); ++t) {
        model.thickness[t] = 0.05 + 0.01 * static_cast<double>(t % 7);
    }
    return model;
}

Vec3 random_vector(Rng& rng, double size) {
    return size * Vec3(2.0 * rng.uniform() - 1.0, 2.0 * rng.uniform() - 1.0, 2.0 * rng.uniform() - 1.0);
}

ShellState random_state(const ShellModel& model, Rng& rng, double size) {
    ShellState state = rest_state(model);
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        state.position[n] += random_vector(rng, 0.1 * size);
        state.rotation[n] = Quat(cayley(random_vector(rng, size)));
    }
    return state;
}

/// By rows, with turns of each node from the state's rotations.
std::vector<double> rows_of(const ShellBody& body, const ShellState& state, Rng& rng, double turn) {
    std::vector<double> x(6 * state.position.size() + 1, 0.0);
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        const std::size_t first = 6 * at(body.rank(static_cast<int>(n)));
        Eigen::Map<Vec3>(x.data() + first) = state.position[n];
        Eigen::Map<Vec3>(x.data() + first + 3) = random_vector(rng, turn);
    }
    return x;
}

MatX dense(const ShellBody& body, const BlockValues& values) {
    BlockValues whole = values;
    mirror_upper(body.pattern(), whole);
    MatX result = MatX::Zero(3 * body.rows(), 3 * body.rows());
    for (int i = 0; i < body.rows(); ++i) {
        for (int slot = body.pattern().first[at(i)]; slot < body.pattern().first[at(i) + 1]; ++slot) {
            result.block<3, 3>(3 * i, 3 * body.pattern().column[at(slot)]) = block_of(whole, slot);
        }
    }
    return result;
}

}  // namespace

TEST_SUITE("shell body") {
    TEST_CASE("forces and stiffness are those of the triangles, and derivatives of each other, for turns of any size") {
        Rng rng(1, "shell body");
        for (const double turn : {0.0, 0.7}) {
            const ShellModel model = sample();
            ShellBody body(model, *shell_kernel::choose({}));
            const ShellState state = random_state(model, rng, 0.3);
            body.set_reference(state.rotation);
            const std::vector<double> x = rows_of(body, state, rng, turn);
            std::vector<double> force;
            BlockValues stiffness = zero_values(body.pattern());
            body.forces_and_stiffness(x, elastic_kernel::Mode::consistent, 2.0, force, stiffness);
            const auto energy = [&](const VecX& rows) {
                double sum = 0.0;
                for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
                    const std::array<int, 3>& n = model.mesh.triangles[t];
                    ShellCorners corners;
                    std::array<Vec3, 3> rest;
                    for (std::size_t a = 0; a < 3; ++a) {
                        const Eigen::Index first = 6 * body.rank(n[a]);
                        rest[a] = model.mesh.nodes[at(n[a])];
                        corners.position[a] = rows.segment<3>(first);
                        corners.rotation[a] =
                            cayley(rows.segment<3>(first + 3)) * state.rotation[at(n[a])].toRotationMatrix();
                    }
                    sum += shell_energy(shell_triangle(rest, model.thickness[t], model.material.young_modulus,
                                                       model.material.poisson_ratio),
                                        corners);
                }
                return VecX(VecX::Constant(1, -sum));
            };
            const auto forces = [&](const VecX& rows) {
                std::vector<double> there(rows.data(), rows.data() + rows.size());
                there.push_back(0.0);
                std::vector<double> result;
                body.forces(there, result);
                return VecX(Eigen::Map<const VecX>(result.data(), rows.size()));
            };
            const VecX here = Eigen::Map<const VecX>(x.data(), static_cast<Eigen::Index>(x.size()) - 1);
            const VecX f = Eigen::Map<const VecX>(force.data(), here.size());
            CHECK(rhexis::test::derivative_error(energy, here, f.transpose(), 1e-4) < 1e-6);
            const MatX rate = -rhexis::test::finite_difference(forces, here, 1e-3);
            const MatX k = 0.5 * dense(body, stiffness);
            const MatX symmetric = 0.5 * (rate + rate.transpose());
            CHECK((symmetric - k).cwiseAbs().maxCoeff() < 1e-6 * k.cwiseAbs().maxCoeff());
        }
    }

    TEST_CASE("every instruction set gives the same bits") {
        const ShellModel model = sample();
        Rng rng(2, "shell body");
        const ShellState state = random_state(model, rng, 0.3);
        std::vector<double> reference;
        for (const shell_kernel::Kernel* kernel :
             {shell_kernel::baseline(), shell_kernel::choose("avx2"), shell_kernel::choose("avx512")}) {
            if (kernel == nullptr) {
                continue;
            }
            ShellBody body(model, *kernel);
            body.set_reference(state.rotation);
            Rng same(3, "turns");
            const std::vector<double> x = rows_of(body, state, same, 0.2);
            std::vector<double> all;
            for (const elastic_kernel::Mode mode :
                 {elastic_kernel::Mode::consistent, elastic_kernel::Mode::projected}) {
                std::vector<double> force;
                BlockValues stiffness = zero_values(body.pattern());
                body.forces_and_stiffness(x, mode, 1.0, force, stiffness);
                all.insert(all.end(), force.begin(), force.end());
                all.insert(all.end(), stiffness.begin(), stiffness.end() - 10);
            }
            if (reference.empty()) {
                reference = all;
            }
            CHECK(all == reference);
        }
    }
}
