// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "mesh/validate.hpp"
#include "scenes/bodies.hpp"

using namespace rhexis;

TEST_SUITE("scenes") {
    TEST_CASE("every shared body is a valid two-level mesh") {
        for (const SolidModel& solid :
             {scenes::clamped_bar(8, 2, 2, 0.5, 3000.0, 0.45), scenes::cube(3, 2.0, 3000.0, 0.45),
              scenes::ball_body(1.0, 500, 3000.0, 0.45), scenes::default_eye(500).lens}) {
            CHECK(validate_mesh(solid.coarse).ok());
            CHECK(solid.fine.tets.size() == 8 * solid.coarse.tets.size());
            const SolidState state = rest_state(solid);
            CHECK(remaining_mass(solid, state) == doctest::Approx(1.05e-3 * mesh_volume(solid.coarse)).epsilon(1e-12));
        }
        CHECK(scenes::clamped_bar(8, 2, 2, 0.5, 3000.0, 0.45).fixed_nodes.size() == 9);
        CHECK(mesh_volume(scenes::cube(3, 2.0, 3000.0, 0.45).coarse) == doctest::Approx(8.0));
    }

    TEST_CASE("the reference cases load with the nodes that their load case names") {
        const Result<scenes::ReferenceCase> small = scenes::reference_case("lens_3000");
        REQUIRE(small.ok());
        CHECK(small.value().solid.fixed_nodes.size() == 76);
        CHECK(small.value().poke_nodes.size() == 9);
        for (int node : small.value().poke_nodes) {
            CHECK(small.value().solid.coarse.nodes[static_cast<std::size_t>(node)].z() > 2.0);
        }
        const Result<scenes::ReferenceCase> large = scenes::reference_case("lens_12000");
        REQUIRE(large.ok());
        CHECK(large.value().solid.coarse.tets.size() == 11932);
        CHECK(large.value().solid.fixed_nodes.size() == 199);
        CHECK(large.value().poke_nodes.size() == 29);
        CHECK(!scenes::reference_case("lens_9").ok());
    }
}
