// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "mesh/shapes.hpp"
#include "physics/contact/piece_contact.hpp"
#include "physics/physics.hpp"
#include "scenes/bodies.hpp"

using namespace rhexis;

namespace {

constexpr double cell = 2.0 / 3.0;
constexpr double aside = 0.25 * cell;
constexpr double modulus = 50000.0;

/// Two blocks on one another, 2 mm wide and so many cells high, the upper one's nodes beside the lower one's.
TetMesh two_blocks(double gap, int layers = 3) {
    TetMesh both = bar(3, 3, layers, cell, {0.0, 0.0, -layers * cell});
    const TetMesh upper = bar(3, 3, layers, cell, {aside, aside, gap});
    const int first = static_cast<int>(both.nodes.size());
    both.nodes.insert(both.nodes.end(), upper.nodes.begin(), upper.nodes.end());
    for (const std::array<int, 4>& tet : upper.tets) {
        both.tets.push_back({tet[0] + first, tet[1] + first, tet[2] + first, tet[3] + first});
        both.region.push_back(0);
    }
    return both;
}

std::vector<PiecePair> pairs_of(const TetMesh& mesh) {
    WorldModel world;
    world.solids = {scenes::body("pieces", mesh, modulus, 0.0)};
    const WorldState state = rest_state(world);
    ContactSurface surface(world.solids[0]);
    surface.update(world.solids[0], state.solids[0]);
    std::vector<PiecePair> pairs;
    find_piece_pairs(surface, state.solids[0].position, pairs);
    return pairs;
}

/// How far the upper block's top has sunk when it is pressed on the lower one by this strain, share of Hooke's law.
/// Two layers each: a pile of 4 mm with a free top would buckle at 5 % whatever the contact does (Euler).
double pressed(double strain, double dt) {
    constexpr int layers = 2;
    constexpr double height = layers * cell;
    WorldModel world;
    world.solids = {scenes::body("pieces", two_blocks(0.0, layers), modulus, 0.0)};
    SolidModel& solid = world.solids[0];
    solid.advance = Advance::explicit_;
    solid.formulation = Formulation::nodal_pressure;
    solid.sought_step = 3e-4;
    solid.damping_mass = 20.0;
    world.gravity = Vec3::Zero();
    NodeLoad load;
    for (int node = 0; node < static_cast<int>(solid.coarse.nodes.size()); ++node) {
        const double z = solid.coarse.nodes[node].z();
        if (z < -height + 1e-9) {
            solid.fixed_nodes.push_back(node);
        } else if (z > height - 1e-9) {
            load.nodes.push_back(node);
        }
    }
    WorldState state = rest_state(world);
    Result<Physics> made = Physics::create(std::make_shared<WorldModel>(world), {});
    REQUIRE(made.ok());
    Physics physics = std::move(made).value();
    ContactSet contacts;
    Profile profile;
    const int count = static_cast<int>(std::lround(0.6 / dt));
    for (int i = 0; i < count; ++i) {
        load.total.z() = -4.0 * modulus * strain * std::min(1.0, 1.5 * (i + 1.0) / count);
        state.loads = {load};
        WorldState next;
        REQUIRE(physics.advance(state, {}, dt, next, contacts, profile).failure == StepFailure::none);
        state = next;
    }
    double sunk = 0.0;
    for (const int node : load.nodes) {
        sunk += (height - state.solids[0].position[node].z()) / static_cast<double>(load.nodes.size());
    }
    return sunk / (2.0 * height * strain);
}

}  // namespace

TEST_SUITE("pieces against each other") {
    TEST_CASE("a body in one piece: no pairs; pieces out of reach: none") {
        CHECK(pairs_of(bar(3, 3, 3, cell)).empty());
        CHECK(pairs_of(two_blocks(0.4)).empty());
        CHECK(!pairs_of(two_blocks(0.3)).empty());
    }

    TEST_CASE("planes are those of faces, rims and corners too; feet are right before the vertices") {
        const TetMesh mesh = two_blocks(0.1);
        const std::vector<PiecePair> pairs = pairs_of(mesh);
        int downward = 0;
        for (const PiecePair& pair : pairs) {
            double sum = 0.0;
            for (const double weight : pair.foot.weights) {
                CHECK(weight >= 0.0);
                sum += weight;
            }
            CHECK(sum == doctest::Approx(1.0));
            CHECK(std::abs(pair.normal.z()) == doctest::Approx(1.0));
            const Vec3 between = point_of(pair.vertex, mesh.nodes) - point_of(pair.foot, mesh.nodes);
            CHECK(pair.normal.dot(between) == doctest::Approx(0.1));
            CHECK(between.head<2>().norm() < 1e-9);
            downward += pair.normal.z() < 0.0 ? 1 : 0;
        }
        CHECK(downward == 9);  // of four by four vertices of each, those that are not beside the other
        CHECK(pairs.size() == 18);
    }

    TEST_CASE("Hooke's law across the gap, in steps of any length") {
        const double usual = pressed(0.02, 0.01);
        CHECK(usual > 1.0);
        CHECK(usual < 1.25);  // a sixth of their faces has nothing before it
        CHECK(pressed(0.02, 0.002) == doctest::Approx(usual).epsilon(0.02));
        CHECK(pressed(0.02, 0.02) == doctest::Approx(usual).epsilon(0.02));
    }

    TEST_CASE("pressed by 5 % it does not fall through") { CHECK(pressed(0.05, 0.01) < 1.3); }
}
