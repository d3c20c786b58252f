// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "energy/shell_triangle.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "physics/shell/shell_body.hpp"
#include "physics/shell/shell_statics.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "scenes/shell_problems.hpp"
#include "scenes/shells.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

/// A curved sheet of varying thickness.
ShellModel sample() {
    const auto map = [](double s, double t) { return Vec3(2.0 * s, 1.5 * t + 0.2 * s, 0.5 * s * s - 0.3 * s * t); };
    ShellModel model = uniform_shell("sample", scenes::grid_mesh(4, 3, scenes::GridCut::alternate, map), 0.1);
    for (std::size_t t = 0; t < model.thickness.size(); ++t) {
        model.thickness[t] = 0.05 + 0.01 * static_cast<double>(t % 7);
    }
    return model;
}

Vec3 random_vector(Rng& rng, double size) { return size * (2.0 * uniform3(rng) - Vec3::Ones()); }

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

TEST_SUITE("shell step") {
    TEST_CASE("steps come to rest where the static solution is, with one solve a step or with many") {
        const scenes::LiftedDisc disc = scenes::lifted_disc().value();
        ShellLoad load = scenes::disc_load(disc, 1.0);
        for (std::size_t t = 0; t < disc.model.mesh.triangles.size(); ++t) {
            const std::array<int, 3>& n = disc.model.mesh.triangles[t];
            const std::vector<Vec3>& x = disc.model.mesh.nodes;
            const double third = disc.model.material.density * disc.model.thickness[t] / 3.0 *
                                 triangle_area(x[at(n[0])], x[at(n[1])], x[at(n[2])]);
            for (const int node : n) {
                load.force[at(node)] += third * disc.gravity;
            }
        }
        ShellState still = rest_state(disc.model);
        ShellStatics statics = std::move(ShellStatics::create(disc.model)).value();
        REQUIRE(statics.load_to(load, 0.0, 1.0, {}, still).converged);
        const double lift = still.position[at(disc.lifted[0])].z();
        CHECK(lift > 1.0);  // a third of the radius: far from linear
        for (const int newton : {1, 20}) {
            ShellStepper stepper = std::move(ShellStepper::create(disc.model)).value();
            ShellState state = rest_state(disc.model);
            for (int i = 0; i < 100; ++i) {
                stepper.step(state, scenes::disc_load(disc, 1.0), disc.gravity, 0.01,
                             {.tolerance = 1e-9, .max_newton = newton}, state);
            }
            CHECK(state.position[at(disc.lifted[0])].z() == doctest::Approx(lift).epsilon(1e-5));
            CHECK(check_shell_state(disc.model, state).ok());
        }
        // the clamp bears what the load and the weight bring
        Vec3 borne = Vec3::Zero();
        for (const ShellHold& hold : disc.model.holds) {
            borne += statics.reaction(still, hold.node).head<3>();
        }
        Vec3 brought = Vec3::Zero();
        for (int n = 0; n < static_cast<int>(load.force.size()); ++n) {
            const bool held = std::any_of(disc.model.holds.begin(), disc.model.holds.end(),
                                          [&](const ShellHold& hold) { return hold.node == n; });
            brought += held ? Vec3(Vec3::Zero()) : load.force[at(n)];
        }
        CHECK((borne - brought).norm() < 1e-5 * brought.norm());
    }

    TEST_CASE("Newton's method balances a step in few iterations, from 1 to 10 ms") {
        scenes::LiftedDisc disc = scenes::lifted_disc().value();
        disc.model.damping_stiffness = 0.0;
        for (const double dt : {0.001, 0.01}) {
            ShellStepper stepper = std::move(ShellStepper::create(disc.model)).value();
            ShellState state = rest_state(disc.model);
            int iterations = 0;
            for (int i = 0; i < 50; ++i) {
                const ImplicitReport report =
                    stepper.step(state, scenes::disc_load(disc, scenes::moving_share(i * dt)), disc.gravity, dt,
                                 {.tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-6}, state);
                CHECK(report.converged);
                iterations += report.newton_iterations;
            }
            CHECK(iterations < 50 * 6);
        }
    }

    TEST_CASE("a flat ring is thrown out of its plane in one long step: few iterations with predicted stress (T9)") {
        scenes::ShellProblem ring = scenes::slit_ring(30, 4);
        ring.model.material.density = 1e-3;
        int iterations[2] = {0, 0};
        ShellState end[2];
        for (const bool predict : {false, true}) {
            ShellStepper stepper = std::move(ShellStepper::create(ring.model)).value();
            ShellState state = rest_state(ring.model);
            for (int i = 0; i < 3; ++i) {
                const ImplicitReport report = stepper.step(
                    state, ring.load, Vec3::Zero(), 0.01,
                    {.tolerance = 1e-3, .max_newton = 60, .newton_tolerance = 1e-6, .predict_stress = predict}, state);
                CHECK(report.converged);
                iterations[predict ? 1 : 0] += report.newton_iterations;
            }
            end[predict ? 1 : 0] = state;
        }
        CHECK(iterations[1] < 25);
        CHECK(2 * iterations[1] < iterations[0]);
        CHECK((end[0].position[0] - end[1].position[0]).norm() < 1e-4);
        CHECK(end[0].position[0].z() > 3.0);
    }

    TEST_CASE("in free flight momentum stays (T20), and a spinning shell stays as it is") {
        ShellModel model = sample();
        ShellState state = rest_state(model);
        const Vec3 spin(0.0, 0.0, 5.0);
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            state.velocity[n] = Vec3(1.0, 2.0, -1.0) + spin.cross(state.position[n]);
            state.spin[n] = spin;
        }
        ShellStepper stepper = std::move(ShellStepper::create(model)).value();
        std::vector<double> mass(state.position.size(), 0.0);
        for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
            const std::array<int, 3>& n = model.mesh.triangles[t];
            for (const int node : n) {
                mass[at(node)] +=
                    model.thickness[t] *
                    triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
            }
        }
        const auto momentum = [&] {
            Vec3 sum = Vec3::Zero();
            for (std::size_t n = 0; n < mass.size(); ++n) {
                sum += mass[n] * state.velocity[n];
            }
            return sum;
        };
        const Vec3 before = momentum();
        for (int i = 0; i < 100; ++i) {
            const ImplicitReport report =
                stepper.step(state, {}, Vec3::Zero(), 0.001,
                             {.tolerance = 1e-8, .max_newton = 30, .newton_tolerance = 1e-10}, state);
            CHECK(report.converged);
        }
        CHECK((momentum() - before).norm() < 1e-9 * before.norm());
        CHECK(state.rotation[0].angularDistance(state.rotation[5]) < 0.02);  // it has turned by half a radian
        CHECK(state.rotation[0].angularDistance(Quat::Identity()) > 0.4);
    }

    TEST_CASE("a roof snaps through and comes to rest beyond (T10)") {
        scenes::ShellProblem roof = scenes::hinged_roof(8, 12.7);
        roof.model.material.density = 1e-3;
        roof.model.damping_mass = 0.3;
        for (Vec3& force : roof.load.force) {
            force *= 0.85;  // above the limit point at 0.74
        }
        ShellStepper stepper = std::move(ShellStepper::create(roof.model)).value();
        ShellState state = rest_state(roof.model);
        double fastest = 0.0;
        double speed = 0.0;
        for (int i = 0; i < 800; ++i) {
            const ImplicitReport report =
                stepper.step(state, roof.load, Vec3::Zero(), 0.1,
                             {.tolerance = 1e-3, .max_newton = 40, .newton_tolerance = 1e-6}, state);
            CHECK(report.converged);
            speed = state.velocity[0].norm();
            fastest = std::max(fastest, speed);
        }
        CHECK(roof.measure(state)[0] > 25.0);
        CHECK(speed < 1e-3 * fastest);
    }

    TEST_CASE("every instruction set steps to the same bits") {
        const scenes::LiftedDisc disc = scenes::lifted_disc().value();
        std::vector<Vec3> reference;
        for (const char* set : {"baseline", "avx2", "avx512"}) {
            Result<ShellStepper> stepper = ShellStepper::create(disc.model, set);
            if (!stepper.ok()) {
                continue;
            }
            ShellState state = rest_state(disc.model);
            for (int i = 0; i < 5; ++i) {
                stepper.value().step(state, scenes::disc_load(disc, 1.0), disc.gravity, 0.01, {}, state);
            }
            reference = reference.empty() ? state.position : reference;
            CHECK(state.position == reference);
        }
    }
}

TEST_SUITE("shell model") {
    TEST_CASE("what is no shell is refused, with field and range") {
        const auto refused = [](const auto& change, const std::string& part) {
            ShellModel model = sample();
            change(model);
            const Result<ShellStepper> stepper = ShellStepper::create(model);
            CHECK_FALSE(stepper.ok());
            if (!stepper.ok()) {
                CHECK(stepper.error().text().find(part) != std::string::npos);
                CHECK(stepper.error().text().find("sample") != std::string::npos);
            }
            CHECK_FALSE(ShellStatics::create(model).ok());
        };
        refused([](ShellModel& m) { m.thickness[3] = -0.1; }, "thickness of triangle 3");
        refused([](ShellModel& m) { m.thickness[3] = std::nan(""); }, "thickness of triangle 3");
        refused([](ShellModel& m) { m.thickness.pop_back(); }, "one per triangle");
        refused([](ShellModel& m) { m.material.young_modulus = 0.0; }, "young_modulus");
        refused([](ShellModel& m) { m.material.poisson_ratio = 0.5; }, "poisson_ratio");
        refused([](ShellModel& m) { m.material.density = -1.0; }, "density");
        refused([](ShellModel& m) { m.damping_mass = -1.0; }, "damping_mass");
        refused([](ShellModel& m) { m.holds = {ShellHold{99}}; }, "holds names node 99");
        refused([](ShellModel& m) { m.holds = {ShellHold{2}, ShellHold{1}}; }, "ascending");
        refused([](ShellModel& m) { m.mesh.triangles[0] = {0, 0, 1}; }, "triangle 0");
        CHECK_FALSE(ShellStepper::create(sample(), "mmx").ok());
        ShellState state = rest_state(sample());
        CHECK(check_shell_state(sample(), state).ok());
        state.rotation[2] = Quat(2.0, 0.0, 0.0, 0.0);
        CHECK_FALSE(check_shell_state(sample(), state).ok());
    }
}
