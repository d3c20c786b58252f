// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/implicit_solid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/rng.hpp"
#include "mesh/shapes.hpp"
#include "physics/solid_share.hpp"

using namespace rhexis;

namespace {

SolidModel bar_model(int across, double young, double poisson, bool clamped) {
    SolidModel model;
    model.name = "bar";
    model.coarse = bar(4 * across, across, across, 1.0 / across);
    model.materials = {Material{.name = "gel", .young_modulus = young, .poisson_ratio = poisson, .density = 1e-3}};
    for (std::size_t i = 0; clamped && i < model.coarse.nodes.size(); ++i) {
        if (model.coarse.nodes[i].x() < 1e-9) {
            model.fixed_nodes.push_back(static_cast<int>(i));
        }
    }
    return model;
}

ImplicitSolid make(const SolidModel& model, ThreadPool& pool) {
    Result<ImplicitSolid> made = ImplicitSolid::create(model, pool);
    REQUIRE(made.ok());
    return std::move(made).value();
}

const ImplicitSettings linear_step{.tolerance = 1e-9, .max_newton = 1};
const ImplicitSettings newton_step{.tolerance = 1e-9, .max_newton = 20, .newton_tolerance = 1e-8};

double tip_sag(const SolidModel& model, const SolidState& state) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        if (model.coarse.nodes[i].x() > 4.0 - 1e-9) {
            sum += model.coarse.nodes[i].z() - state.position[i].z();
            ++count;
        }
    }
    return sum / count;
}

SolidState settle(const SolidModel& model, double gravity, double dt, int steps, const ImplicitSettings& settings) {
    ThreadPool pool(1);
    ImplicitSolid solid = make(model, pool);
    SolidState state = rest_state(model);
    SolidState next;
    std::vector<RigidUnknown> none;
    for (int i = 0; i < steps; ++i) {
        const ImplicitReport report = solid.step(state, {0.0, 0.0, -gravity}, {}, dt, settings, {}, none, next);
        REQUIRE(report.converged);
        std::swap(state, next);
    }
    return state;
}

}  // namespace

TEST_SUITE("physics") {
    TEST_CASE("a bar under its own weight sags as linear tetrahedra do") {
        // weight 1 uN/mm^3; ratios to the quadratic reference for two and three elements across
        const double sag2 = tip_sag(bar_model(2, 3000.0, 0.3, true),
                                    settle(bar_model(2, 3000.0, 0.3, true), 1000.0, 0.2, 40, linear_step));
        CHECK(sag2 / 0.13284 == doctest::Approx(0.668).epsilon(0.01));
        const double sag3 = tip_sag(bar_model(3, 3000.0, 0.45, true),
                                    settle(bar_model(3, 3000.0, 0.45, true), 1000.0, 0.2, 40, linear_step));
        CHECK(sag3 / 0.12847 == doctest::Approx(0.762).epsilon(0.01));
    }

    TEST_CASE("a free body falls as backward Euler says") {
        const SolidModel model = bar_model(1, 3000.0, 0.45, false);
        const SolidState state = settle(model, 9810.0, 0.01, 10, newton_step);
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            CHECK(std::abs(state.velocity[i].z() + 981.0) < 1e-7);
            CHECK(std::abs(state.position[i].z() - model.coarse.nodes[i].z() + 9810.0 * 1e-4 * 55.0) < 1e-8);
        }
    }

    TEST_CASE("a solid hung on a light rigid body by stiff springs keeps the momentum of the pair") {
        const SolidModel model = bar_model(1, 3000.0, 0.45, false);
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState state = rest_state(model);
        SolidState next;
        Rng random(7);
        for (Vec3& velocity : state.velocity) {
            velocity = 10.0 * Vec3(random.normal(), random.normal(), random.normal());
        }
        std::vector<RigidUnknown> bodies(1);
        bodies[0].velocity << 5.0, -3.0, 2.0, 0.5, -0.2, 0.1;
        const std::vector<Vec3> anchor = model.coarse.nodes;
        const double mass = 0.002;
        const CouplingFunction springs = [&](const std::vector<Vec3>& x, std::span<const RigidUnknown> body,
                                             std::vector<ContactTerm>& contacts, std::vector<RigidTerm>& rigid) {
            rigid[0].mass = Mat6::Identity() * mass;
            for (int i = 0; i < static_cast<int>(x.size()); i += 3) {
                ContactTerm term;
                term.nodes = {i, (i + 1) % static_cast<int>(x.size()), -1};
                term.weights = {0.25, 0.75, 0.0};
                term.body = 0;
                const auto a = static_cast<std::size_t>(term.nodes[0]);
                const auto b = static_cast<std::size_t>(term.nodes[1]);
                term.arm = body[0].pose.orientation * (0.25 * anchor[a] + 0.75 * anchor[b]);
                term.stiffness = 30000.0 * Mat3::Identity();
                term.force = -30000.0 * (0.25 * x[a] + 0.75 * x[b] - body[0].pose.position - term.arm);
                contacts.push_back(term);
            }
        };
        const auto momentum = [&](const SolidState& s) {
            Vec3 sum = mass * bodies[0].velocity.head<3>();
            const std::vector<TetStiffness> stiffness = tet_stiffness(model, s);
            const NodeMass nodes = node_mass(model, s, stiffness);
            for (std::size_t i = 0; i < s.velocity.size(); ++i) {
                sum += nodes.inertia[i] * s.velocity[i];
            }
            return sum;
        };
        const Vec3 before = momentum(state);
        for (int i = 0; i < 10; ++i) {
            const ImplicitReport report = solid.step(state, Vec3::Zero(), {}, 0.01, newton_step, springs, bodies, next);
            CHECK(report.converged);
            CHECK(report.linear_iterations <= 40 * report.newton_iterations);
            std::swap(state, next);
        }
        CHECK((momentum(state) - before).norm() < 1e-7 * before.norm());
    }

    TEST_CASE("a state that is not finite is reported at once") {
        const SolidModel model = bar_model(1, 3000.0, 0.45, true);
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState state = rest_state(model);
        state.position[5].y() = std::numeric_limits<double>::quiet_NaN();
        SolidState next;
        std::vector<RigidUnknown> none;
        const ImplicitReport report = solid.step(state, Vec3::Zero(), {}, 0.01, newton_step, {}, none, next);
        CHECK_FALSE(report.converged);
        CHECK_FALSE(std::isfinite(report.residual));
        CHECK(report.linear_iterations == 0);
    }

    TEST_CASE("elements removed in random order to the last one end quietly") {
        const SolidModel model = bar_model(2, 3000.0, 0.45, true);
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState state = rest_state(model);
        SolidState next;
        std::vector<RigidUnknown> none;
        Rng random(3);
        std::vector<int> left(model.coarse.tets.size());
        for (std::size_t t = 0; t < left.size(); ++t) {
            left[t] = static_cast<int>(t);
        }
        while (!left.empty()) {
            for (int i = 0; i < 4 && !left.empty(); ++i) {
                const std::size_t pick = static_cast<std::size_t>(random.next() % left.size());
                state.present[static_cast<std::size_t>(left[pick])] = 0;
                left[pick] = left.back();
                left.pop_back();
            }
            const ImplicitReport report = solid.step(state, {0.0, 0.0, -9810.0}, {}, 0.01, newton_step, {}, none, next);
            REQUIRE(report.newton_residual < 0.1);
            std::swap(state, next);
        }
        for (const Vec3& velocity : state.velocity) {
            CHECK(velocity.norm() == 0.0);
        }
    }
}
