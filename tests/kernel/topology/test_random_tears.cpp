// SPDX-License-Identifier: GPL-3.0-or-later
// Short: the stability gate T18 and `rhexis bench random_tears` go on for longer.
#include <doctest/doctest.h>

#include "scenes/random_tears.hpp"

using namespace rhexis;

namespace {

void check_sound(const scenes::RandomTears& found) {
    CHECK_MESSAGE(found.fault.empty(), found.fault);
    CHECK(found.most_cosine <= 0.0);
    CHECK(found.least_edge >= 0.1);
    CHECK(found.most_of_bound <= 1.0);
    CHECK(found.most_per_triangle <= 3.0);
    CHECK(found.area_off < 1e-12);
    CHECK(found.mass_off < 1e-12);
    CHECK(found.torn_off < 1e-10);
    CHECK(found.energy_off < 1e-10);
    CHECK(found.elastic_off < 1e-10);
}

}  // namespace

TEST_SUITE("random tears") {
    TEST_CASE("edits, grasps, pulls and stabs at random: no sliver, no fault, all accounts kept") {
        const scenes::RandomTears found = scenes::random_tears({.operations = 100});
        check_sound(found);
        CHECK(found.edits > 30);
        CHECK(found.mad > 0);
        CHECK(found.grasps > 2);
        CHECK(found.pulls > 2);
        CHECK(found.given_up == 0);
    }

    TEST_CASE("torn to scraps by edits alone, the last ones are not split for ever") {
        const scenes::RandomTears found =
            scenes::random_tears({.operations = 2500, .longest_sheet = 4000, .by_instrument = 0.0});
        check_sound(found);
        CHECK(found.most_triangles > 500);
    }

    TEST_CASE("the same seed gives the same bits") {
        const scenes::RandomTearsTask task{.operations = 25, .seed = 7};
        CHECK(scenes::random_tears(task).print == scenes::random_tears(task).print);
        CHECK(scenes::random_tears(task).print != scenes::random_tears({.operations = 25, .seed = 8}).print);
    }
}
