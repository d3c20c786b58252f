// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/hash.hpp"
#include "base/index.hpp"
#include "base/rng.hpp"
#include "energy/corotational.hpp"
#include "energy/corotational_tet.hpp"
#include "energy/nodal_pressure.hpp"
#include "math/random_vectors.hpp"
#include "physics/solid/explicit_groups.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "physics/solid/solid_share.hpp"
#include "physics/solid/stable_step.hpp"
#include "scenes/bodies.hpp"
#include "scenes/eigenvalues.hpp"

using namespace rhexis;

namespace {

ExplicitSolid make(const SolidModel& model, std::string_view set = "") {
    Result<ExplicitSolid> solid = ExplicitSolid::create(model, set);
    REQUIRE(solid.ok());
    return std::move(solid).value();
}

/// What the patches of nodal pressure add to the force.
void add_patch_force(const SolidModel& model, const SolidState& state, const std::vector<TetStiffness>& stiffness,
                     std::vector<Vec3>& force) {
    const ElementDomains domains = element_domains(model.coarse, Formulation::nodal_pressure);
    const std::vector<double>& volume = domains.rest_volume;
    std::vector<CorotationalPoint> points;
    std::vector<double> theta;
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        Mat3 f = Mat3::Zero();
        for (std::size_t a = 0; a < 4; ++a) {
            f += state.position[at(model.coarse.tets[t][a])] * domains.rest_gradient[4 * t + a].transpose();
        }
        points.push_back(corotational_point(f));
        theta.push_back(points.back().trace - 3.0);
    }
    const NodePatches patches = node_patches(model.coarse, volume, stiffness);
    const std::vector<double> pressure = tet_pressures(model.coarse, volume, stiffness, patches, theta);
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        const Mat3 stress = stiffness[t].share * volume[t] * pressure[t] * points[t].rotation;
        for (std::size_t a = 0; a < 4; ++a) {
            force[at(model.coarse.tets[t][a])] -= stress * domains.rest_gradient[4 * t + a];
        }
    }
}

/// Internal force in double, by the energy's own gradient.
std::vector<Vec3> reference_force(const SolidModel& model, const SolidState& state) {
    std::vector<Vec3> force(state.position.size(), Vec3::Zero());
    const std::vector<TetStiffness> stiffness = tet_stiffness(model, state);
    const bool nodal = model.formulation == Formulation::nodal_pressure;
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        TetPoints rest;
        TetPoints now;
        for (std::size_t a = 0; a < 4; ++a) {
            rest[a] = model.coarse.nodes[at(model.coarse.tets[t][a])];
            now[a] = state.position[at(model.coarse.tets[t][a])];
        }
        const double lambda = nodal ? -2.0 / 3.0 * stiffness[t].mu : stiffness[t].lambda;
        const Vec12 g = corotational_tet_gradient(rest_tet(rest), {lambda, stiffness[t].mu}, now);
        for (std::size_t a = 0; a < 4; ++a) {
            force[at(model.coarse.tets[t][a])] -= stiffness[t].share * g.segment<3>(static_cast<Eigen::Index>(3 * a));
        }
    }
    if (nodal) {
        add_patch_force(model, state, stiffness, force);
    }
    return force;
}

/// Largest difference between the force that the solid acts on and the reference, over the largest reference force.
double force_error(const SolidModel& model, const SolidState& state, std::string_view set) {
    ExplicitSolid solid = make(model, set);
    solid.load(state);
    solid.predict(1e-3, Vec3::Zero(), {});
    const std::vector<Vec3> reference = reference_force(model, state);
    double worst = 0.0;
    double largest = 0.0;
    for (int i = 0; i < static_cast<int>(reference.size()); ++i) {
        if (solid.mass(i) > 0.0) {
            worst = std::max(worst, (solid.velocity(i) * solid.mass(i) / 1e-3 - reference[at(i)]).norm());
            largest = std::max(largest, reference[at(i)].norm());
        }
    }
    return worst / largest;
}

SolidState mapped(const SolidModel& model, const Mat3& map) {
    SolidState state = rest_state(model);
    for (Vec3& x : state.position) {
        x = map * x;
    }
    return state;
}

std::uint64_t hash_of(const ExplicitSolid& solid, const SolidModel& model) {
    SolidState state = rest_state(model);
    solid.store(state);
    StateHash hash;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        hash.add(std::span<const double>(state.position[i].data(), 3));
        hash.add(std::span<const double>(state.velocity[i].data(), 3));
    }
    return hash.value();
}

std::vector<std::string> sets_here() {
    std::vector<std::string> result;
    const SolidModel model = scenes::cube(1, 1.0, 3000.0, 0.3);
    for (const char* set : {"baseline", "avx2", "avx512"}) {
        if (ExplicitSolid::create(model, set).ok()) {
            result.emplace_back(set);
        }
    }
    return result;
}

/// A lens that falls, turns, rings and loses elements.
std::uint64_t hash_after(Formulation formulation, const std::string& set, int steps) {
    SolidModel model = scenes::default_eye(1000).lens;
    model.formulation = formulation;
    model.damping_mass = 1.0;
    model.damping_stiffness = 5e-6;
    SolidState state = mapped(model, Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix() *
                                         Vec3(1.3, 0.8, 1.1).asDiagonal());
    ExplicitSolid solid = make(model, set);
    solid.load(state);
    const double dt = 0.5 * solid.stable_step();
    for (int k = 0; k < steps; ++k) {
        if (k == steps / 2) {
            solid.store(state);
            for (std::size_t t = 0; t < 200; ++t) {
                state.fraction[3 * t] = 0.0;
            }
            solid.load(state);
        }
        solid.predict(dt, Vec3(0, 0, -9810.0), {});
        solid.move(dt);
    }
    CHECK(solid.finite());
    return hash_of(solid, model);
}

}  // namespace

TEST_SUITE("physics") {
    TEST_CASE("no two lanes of a group share a node, every element has a lane, and lenses fill 90 % of them") {
        for (const int size : {1000, 3000}) {
            const TetMesh mesh = scenes::default_eye(size).lens.coarse;
            const LaneAssignment packed = assign_lanes(mesh.tets, static_cast<int>(mesh.nodes.size()), 16);
            std::vector<std::set<int>> nodes(at(packed.groups));
            std::set<int> slots;
            for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
                slots.insert(packed.slot[t]);
                for (const int node : mesh.tets[t]) {
                    CHECK(nodes[at(packed.slot[t] / 16)].insert(node).second);
                }
            }
            CHECK(slots.size() == mesh.tets.size());
            CHECK(static_cast<double>(mesh.tets.size()) / (16.0 * packed.groups) > 0.9);
        }
    }

    TEST_CASE("the explicit force is the gradient of the energy, turned, strained, inverted or partly removed") {
        SolidModel model = scenes::default_eye(1000).lens;
        model.damping_mass = 0.0;
        model.damping_stiffness = 0.0;
        Rng rng(5, "force");
        for (const std::string& set : sets_here()) {
            CAPTURE(set);
            model.formulation = Formulation::linear;
            for (const double degrees : {0.0, 45.0, 170.0}) {
                const Mat3 turn = Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3(1, -1, 2).normalized()).matrix();
                for (const Vec3& stretch : {Vec3(1.01, 1.0, 0.99), Vec3(1.4, 0.7, 1.1), Vec3(0.4, 0.5, 0.45),
                                            Vec3(1.2, 0.9, -0.4), Vec3(2.5, 0.1, 0.3), Vec3(1.0, 1.0, 0.0)}) {
                    // positions in float resolve strains of about 3e-6
                    const double strain = (stretch - Vec3::Ones()).norm();
                    CHECK(force_error(model, mapped(model, turn * stretch.asDiagonal()), set) < 1e-5 + 1e-5 / strain);
                }
            }
            SolidState state = mapped(model, Vec3(1.1, 0.9, 1.05).asDiagonal());
            for (std::size_t k = 0; k < state.fraction.size(); ++k) {
                state.fraction[k] = (k / 8) % 7 == 0 ? 0.0 : rng.uniform();
            }
            state.present[3] = 0;
            CHECK(force_error(model, state, set) < 3e-5);
            // every node somewhere else: elements of all shapes; errors grow near the singular set only
            for (Vec3& x : state.position) {
                x += 0.3 * (uniform3(rng) - Vec3::Constant(0.5));
            }
            CHECK(force_error(model, state, set) < 1e-3);
        }
    }

    TEST_CASE("with pressure at nodes the explicit force is the gradient of that energy") {
        SolidModel model = scenes::default_eye(1000).lens;
        model.damping_mass = 0.0;
        model.damping_stiffness = 0.0;
        model.formulation = Formulation::nodal_pressure;
        Rng rng(5, "force");
        for (const std::string& set : sets_here()) {
            CAPTURE(set);
            SolidState state = mapped(
                model, Eigen::AngleAxisd(2.0, Vec3(1, -1, 2).normalized()).matrix() * Vec3(1.2, 0.8, 1.1).asDiagonal());
            for (Vec3& x : state.position) {
                x += 0.1 * (uniform3(rng) - Vec3::Constant(0.5));
            }
            CHECK(force_error(model, state, set) < 1e-5);
            for (std::size_t k = 0; k < state.fraction.size(); ++k) {
                state.fraction[k] = (k / 8) % 7 == 0 ? 0.0 : rng.uniform();
            }
            state.present[3] = 0;
            CHECK(force_error(model, state, set) < 3e-5);
        }
    }

    TEST_CASE("2,000 steps give the same bits with every instruction set of this machine") {
        const std::vector<std::string> sets = sets_here();
        CHECK(sets.front() == "baseline");
        for (const Formulation formulation : {Formulation::linear, Formulation::nodal_pressure}) {
            const std::uint64_t expected = hash_after(formulation, "baseline", 2000);
            for (const std::string& set : sets) {
                CAPTURE(set);
                CHECK(hash_after(formulation, set, 2000) == expected);
            }
        }
    }

    TEST_CASE("storing and loading a state between steps changes nothing") {
        SolidModel model = scenes::cube(3, 2.0, 3000.0, 0.45);
        model.damping_stiffness = 1e-5;
        ExplicitSolid through = make(model);
        ExplicitSolid resumed = make(model);
        SolidState state = mapped(model, Vec3(1.2, 0.9, 1.0).asDiagonal());
        through.load(state);
        const double dt = 0.7 * through.stable_step();
        for (int k = 0; k < 50; ++k) {
            through.predict(dt, Vec3(0, 0, -9810.0), {});
            through.move(dt);
            resumed.load(state);
            resumed.predict(dt, Vec3(0, 0, -9810.0), {});
            resumed.move(dt);
            resumed.store(state);
        }
        CHECK(hash_of(through, model) == hash_of(resumed, model));
        CHECK(through.stable_step() == resumed.stable_step());
    }

    TEST_CASE("fixed nodes stay, and a node that lost its elements has no mass and is left where it was") {
        SolidModel model = scenes::clamped_bar(4, 1, 1, 1.0, 3000.0, 0.3);
        model.fine = FineMesh{};
        ExplicitSolid solid = make(model);
        SolidState state = rest_state(model);
        const int tip = static_cast<int>(model.coarse.nodes.size()) - 1;
        for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
            const std::array<int, 4>& tet = model.coarse.tets[t];
            if (std::find(tet.begin(), tet.end(), tip) != tet.end()) {
                state.present[t] = 0;
            }
        }
        solid.load(state);
        const double dt = 0.5 * solid.stable_step();
        for (int k = 0; k < 200; ++k) {
            solid.predict(dt, Vec3(0, 0, -9810.0), {});
            solid.set_velocity(tip, Vec3(1, 2, 3));
            solid.move(dt);
        }
        CHECK(solid.finite());
        CHECK(solid.mass(tip) == 0.0);
        CHECK(solid.position(tip) == model.coarse.nodes[at(tip)]);
        for (const int node : model.fixed_nodes) {
            CHECK(solid.mass(node) == 0.0);
            CHECK(solid.position(node) == model.coarse.nodes[at(node)]);
        }
        CHECK(solid.position(tip - 1).z() < model.coarse.nodes[at(tip - 1)].z());
    }

    TEST_CASE("the stable step is that of the largest eigenvalue, and the tick beyond it blows up") {
        SolidModel model = scenes::cube(3, 2.0, 3000.0, 0.45);
        const SolidState rest = rest_state(model);
        const std::vector<TetStiffness> stiffness = tet_stiffness(model, rest);
        const NodeMass mass = node_mass(model, rest, stiffness);
        const Eigen::Index size = static_cast<Eigen::Index>(3 * rest.position.size());
        MatX k = MatX::Zero(size, size);
        for (std::size_t t = 0; t < stiffness.size(); ++t) {
            const std::array<int, 4>& tet = model.coarse.tets[t];
            const TetPoints x{rest.position[at(tet[0])], rest.position[at(tet[1])], rest.position[at(tet[2])],
                              rest.position[at(tet[3])]};
            const Mat12 own =
                corotational_tet_hessian(rest_tet(x), {stiffness[t].lambda, stiffness[t].mu}, x, Tangent::consistent);
            for (int a = 0; a < 4; ++a) {
                for (int b = 0; b < 4; ++b) {
                    const double scale = std::sqrt(mass.inertia[at(tet[at(a)])] * mass.inertia[at(tet[at(b)])]);
                    k.block<3, 3>(3 * tet[at(a)], 3 * tet[at(b)]) += own.block<3, 3>(3 * a, 3 * b) / scale;
                }
            }
        }
        const double omega2 = scenes::eigenvalues(k)[size - 1];
        for (const double damping : {0.0, 2e-5}) {
            model.damping_stiffness = damping;
            ExplicitSolid solid = make(model);
            const double limit = symplectic_limit(omega2, damping);
            CHECK(solid.stable_step() == doctest::Approx(limit).epsilon(0.02));
            CHECK(solid.stable_step() < 1.002 * limit);
            for (const double factor : {0.97, 1.05}) {
                SolidState state = rest;
                state.velocity[5] = Vec3(1.0, 0.5, -0.2);
                solid.load(state);
                for (int n = 0; n < 3000 && solid.finite(); ++n) {
                    solid.predict(factor * limit, Vec3::Zero(), {});
                    solid.move(factor * limit);
                }
                const double speed = solid.velocity(5).norm();
                CHECK((std::isfinite(speed) && speed < 10.0) == (factor < 1.0));
            }
        }
    }

    TEST_CASE("gravity, outer forces and damping act on free solids as they do on a particle") {
        SolidModel model = scenes::cube(2, 1.0, 3000.0, 0.3);
        model.buoyancy_density = 0.25 * model.materials[0].density;
        model.damping_mass = 3.0;
        ExplicitSolid solid = make(model);
        const double dt = 1e-4;
        std::vector<Vec3> push(model.coarse.nodes.size());
        double mass = 0.0;
        for (std::size_t i = 0; i < push.size(); ++i) {
            push[i] = Vec3(50.0 * solid.mass(static_cast<int>(i)), 0, 0);
            mass += solid.mass(static_cast<int>(i));
        }
        CHECK(mass == doctest::Approx(model.materials[0].density).epsilon(1e-12));
        for (int k = 0; k < 100; ++k) {
            solid.predict(dt, Vec3(0, 0, -9810.0), push);
            solid.move(dt);
        }
        Vec3 expected = Vec3::Zero();
        for (int k = 0; k < 100; ++k) {
            expected = (expected + dt * Vec3(50.0, 0, -0.75 * 9810.0)) / (1.0 + 3.0 * dt);
        }
        Vec3 mean = Vec3::Zero();
        for (int i = 0; i < static_cast<int>(push.size()); ++i) {
            mean += solid.mass(i) / mass * solid.velocity(i);
        }
        CHECK((mean - expected).norm() < 1e-7 * expected.norm());
    }

    TEST_CASE("an unknown instruction set, a flat element and edge-smoothed elements are refused with one line") {
        SolidModel model = scenes::cube(1, 1.0, 3000.0, 0.3);
        CHECK(ExplicitSolid::create(model, "mmx").error().text().find("\"mmx\"") != std::string::npos);
        SolidModel smoothed = model;
        smoothed.formulation = Formulation::edge_smoothed;
        CHECK(!ExplicitSolid::create(smoothed, "").ok());
        std::swap(model.coarse.tets[2][0], model.coarse.tets[2][1]);
        CHECK(ExplicitSolid::create(model, "").error().text().find("tetrahedron 2") != std::string::npos);
    }
}
