// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/implicit_solid.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"
#include "physics/solid/solid_share.hpp"
#include "scenes/measures.hpp"

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
        const double sag2 =
            scenes::tip_sag(bar_model(2, 3000.0, 0.3, true),
                            settle(bar_model(2, 3000.0, 0.3, true), 1000.0, 0.2, 40, linear_step).position);
        CHECK(sag2 / 0.13284 == doctest::Approx(0.668).epsilon(0.01));
        const double sag3 =
            scenes::tip_sag(bar_model(3, 3000.0, 0.45, true),
                            settle(bar_model(3, 3000.0, 0.45, true), 1000.0, 0.2, 40, linear_step).position);
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
            velocity = 10.0 * normal3(random);
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

    TEST_CASE("constant strain is found to rounding inside an affine boundary") {
        SolidModel model = bar_model(3, 3000.0, 0.45, false);
        Mat3 map;
        map << 1.03, 0.02, -0.01, 0.01, 0.98, 0.03, 0.0, -0.02, 1.02;
        map = Quat(1.0, 0.3, -0.5, 0.8).normalized().toRotationMatrix() * map;
        SolidState state = rest_state(model);
        Rng random(5);
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            const Vec3& rest = model.coarse.nodes[i];
            state.position[i] = map * rest;
            if (rest.x() > 0.01 && rest.x() < 3.99 && rest.y() > 0.01 && rest.y() < 0.99 && rest.z() > 0.01 &&
                rest.z() < 0.99) {
                state.position[i] += 0.02 * normal3(random);
            } else {
                model.fixed_nodes.push_back(static_cast<int>(i));
            }
        }
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState next;
        std::vector<RigidUnknown> none;
        for (int i = 0; i < 30; ++i) {
            const ImplicitReport report = solid.step(state, Vec3::Zero(), {}, 1.0, newton_step, {}, none, next);
            REQUIRE(report.converged);
            std::swap(state, next);
        }
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            CHECK((state.position[i] - map * model.coarse.nodes[i]).norm() < 1e-10);
        }
    }

    TEST_CASE("a small oscillation loses 1 + (omega dt)^2 of its energy in a step") {
        SolidModel model;
        model.name = "corner";
        model.coarse.nodes = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
        model.coarse.tets = {{0, 1, 2, 3}};
        model.coarse.region = {0};
        model.materials = {Material{.name = "gel", .young_modulus = 3000.0, .poisson_ratio = 0.3, .density = 1e-3}};
        model.fixed_nodes = {0, 1, 2};
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        // the free corner moves along the axis z: stiffness V (lambda + 2 mu), mass V density / 4
        const double modulus = 3000.0 * 0.7 / (1.3 * 0.4);
        const double omega = std::sqrt(modulus / (1e-3 / 4.0));
        SolidState state = rest_state(model);
        state.position[3].z() += 1e-6;
        SolidState next;
        std::vector<RigidUnknown> none;
        const double dt = 1.0 / omega;
        const auto energy = [&](const SolidState& s) {
            const double u = s.position[3].z() - 1.0;
            const double v = s.velocity[3].z();
            return 0.5 * modulus * u * u + 0.5 * (1e-3 / 4.0) * v * v;
        };
        for (int i = 0; i < 5; ++i) {
            const double before = energy(state);
            REQUIRE(solid.step(state, Vec3::Zero(), {}, dt, newton_step, {}, none, next).converged);
            CHECK(energy(next) / before == doctest::Approx(0.5).epsilon(1e-5));
            std::swap(state, next);
        }
    }

    TEST_CASE("a bar twisted by 180 degrees settles in one step of a second") {
        SolidModel model = bar_model(2, 3000.0, 0.45, true);
        SolidState state = rest_state(model);
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            const Vec3& rest = model.coarse.nodes[i];
            if (rest.x() > 4.0 - 1e-9) {
                model.fixed_nodes.push_back(static_cast<int>(i));
            }
            const double angle = 3.14159265358979 * rest.x() / 4.0;
            const double y = rest.y() - 0.5;
            const double z = rest.z() - 0.5;
            state.position[i].y() = 0.5 + std::cos(angle) * y - std::sin(angle) * z;
            state.position[i].z() = 0.5 + std::sin(angle) * y + std::cos(angle) * z;
        }
        std::sort(model.fixed_nodes.begin(), model.fixed_nodes.end());
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState next;
        std::vector<RigidUnknown> none;
        const ImplicitReport report = solid.step(state, {0.0, 0.0, -9810.0}, {}, 1.0, newton_step, {}, none, next);
        CHECK(report.converged);
        CHECK(report.newton_iterations <= 20);
    }

    TEST_CASE("a bar bent onto itself by its end settles in one step of a second") {
        SolidModel model = bar_model(2, 3000.0, 0.45, true);
        SolidState state = rest_state(model);
        const double radius = 4.0 / 3.14159265358979;
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            const Vec3& rest = model.coarse.nodes[i];
            if (rest.x() > 4.0 - 1e-9) {
                model.fixed_nodes.push_back(static_cast<int>(i));
            }
            const double angle = rest.x() / radius;
            const double away = radius - (rest.z() - 0.5);
            state.position[i].x() = away * std::sin(angle);
            state.position[i].z() = 0.5 + radius - away * std::cos(angle);
        }
        std::sort(model.fixed_nodes.begin(), model.fixed_nodes.end());
        ThreadPool pool(1);
        ImplicitSolid solid = make(model, pool);
        SolidState next;
        std::vector<RigidUnknown> none;
        const ImplicitReport report = solid.step(state, Vec3::Zero(), {}, 1.0, newton_step, {}, none, next);
        CHECK(report.converged);
        CHECK(report.newton_iterations <= 20);
    }

    TEST_CASE("nearly incompressible tissue still converges in few iterations") {
        for (const double poisson : {0.3, 0.45, 0.49, 0.499}) {
            const SolidModel model = bar_model(3, 3000.0, poisson, true);
            ThreadPool pool(1);
            ImplicitSolid solid = make(model, pool);
            SolidState state = rest_state(model);
            SolidState next;
            std::vector<RigidUnknown> none;
            for (int i = 0; i < 10; ++i) {
                const ImplicitReport report =
                    solid.step(state, {0.0, 0.0, -9810.0}, {}, 0.01, linear_step, {}, none, next);
                CHECK(report.converged);
                CHECK(report.linear_iterations <= 60);
                std::swap(state, next);
            }
        }
    }

    TEST_CASE("slivers do not stop the step") {
        SolidModel model = bar_model(2, 3000.0, 0.45, true);
        // the last interior node almost into the plane of an opposite face
        for (const std::array<int, 4>& tet : model.coarse.tets) {
            Vec3& corner = model.coarse.nodes[static_cast<std::size_t>(tet[0])];
            const Vec3 middle = (model.coarse.nodes[static_cast<std::size_t>(tet[1])] +
                                 model.coarse.nodes[static_cast<std::size_t>(tet[2])] +
                                 model.coarse.nodes[static_cast<std::size_t>(tet[3])]) /
                                3.0;
            const Vec3 old = corner;
            corner = middle + 0.02 * (old - middle);
            bool valid = true;
            for (const std::array<int, 4>& other : model.coarse.tets) {
                const auto at = [&](std::size_t k) { return model.coarse.nodes[static_cast<std::size_t>(other[k])]; };
                valid = valid && tet_volume(at(0), at(1), at(2), at(3)) > 1e-4;
            }
            if (valid) {
                break;
            }
            corner = old;
        }
        const SolidState state = settle(model, 9810.0, 0.01, 20, linear_step);
        CHECK(std::isfinite(scenes::tip_sag(model, state.position)));
    }

    TEST_CASE("the age of the kept factor changes iterations, not the solution") {
        const SolidModel model = bar_model(3, 3000.0, 0.45, true);
        ThreadPool pool(1);
        std::array<int, 3> iterations{};
        std::array<SolidState, 3> ends;
        for (std::size_t kind = 0; kind < 3; ++kind) {
            ImplicitSolid solid = make(model, pool);
            SolidState state = rest_state(model);
            SolidState next;
            std::vector<RigidUnknown> none;
            for (int i = 0; i < 20; ++i) {
                if (kind == 1 || (kind == 2 && i % 4 == 0)) {
                    solid.drop_caches();
                }
                const ImplicitReport report =
                    solid.step(state, {0.0, 0.0, -2000.0}, {}, 0.01, linear_step, {}, none, next);
                REQUIRE(report.converged);
                iterations[kind] += report.linear_iterations;
                std::swap(state, next);
            }
            ends[kind] = state;
        }
        CHECK(iterations[1] < iterations[2]);
        CHECK(iterations[2] < iterations[0]);
        for (std::size_t i = 0; i < ends[0].position.size(); ++i) {
            CHECK((ends[0].position[i] - ends[1].position[i]).norm() < 1e-7);
            CHECK((ends[0].position[i] - ends[2].position[i]).norm() < 1e-7);
        }
    }

    TEST_CASE("the same bits for one and two threads and for every instruction set, and as new after dropping caches") {
        const SolidModel model = bar_model(2, 3000.0, 0.45, true);
        const auto run = [&](int threads, const char* instruction_set, int renew_at) {
            ThreadPool pool(threads);
            Result<ImplicitSolid> made = ImplicitSolid::create(model, pool, instruction_set);
            REQUIRE(made.ok());
            ImplicitSolid solid = std::move(made).value();
            SolidState state = rest_state(model);
            SolidState next;
            std::vector<RigidUnknown> none;
            for (int i = 0; i < 12; ++i) {
                if (i == 6) {
                    solid.drop_caches();
                }
                if (i == renew_at) {
                    solid = std::move(ImplicitSolid::create(model, pool, instruction_set)).value();
                }
                state.present[static_cast<std::size_t>(7 * i)] = 0;
                const ImplicitSettings& settings = i % 3 == 0 ? newton_step : linear_step;
                solid.step(state, {0.0, 0.0, -9810.0}, {}, 0.01, settings, {}, none, next);
                std::swap(state, next);
            }
            return state;
        };
        const SolidState first = run(1, "", -1);
        const auto same = [&](const SolidState& other) {
            return other.position == first.position && other.velocity == first.velocity;
        };
        CHECK(same(run(2, "", -1)));
        CHECK(same(run(1, "", 6)));
        CHECK(same(run(1, "baseline", -1)));
        for (const char* name : {"avx2", "avx512"}) {
            ThreadPool pool(1);
            if (ImplicitSolid::create(model, pool, name).ok()) {
                CHECK(same(run(1, name, -1)));
            }
        }
    }

    TEST_CASE("an instruction set that does not exist is refused") {
        const SolidModel model = bar_model(1, 3000.0, 0.45, true);
        ThreadPool pool(1);
        const Result<ImplicitSolid> made = ImplicitSolid::create(model, pool, "mmx");
        REQUIRE_FALSE(made.ok());
        CHECK(made.error().what.find("mmx") != std::string::npos);
    }
}
