// SPDX-License-Identifier: GPL-3.0-or-later
// Tears against the two loads of thin sheets that need no mesh [RivlinThomas1953], and against a crack in the middle.
#include <doctest/doctest.h>

#include <cmath>

#include "mesh/shapes.hpp"
#include "scenes/tears.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

TEST_SUITE("tearing") {
    TEST_CASE("pure shear: a long strip tears at W H0 = Gc") {
        for (const int triangles : {600, 2400}) {
            const TearLoad load = pure_shear(triangles, 500.0);
            CHECK(load.steps > 3);
            CHECK(load.measured == doctest::Approx(load.expected).epsilon(0.05));
        }
    }

    TEST_CASE("trousers: legs tear at 2 F / h = Gc, the stretch of the legs counted") {
        for (const int triangles : {400, 900}) {
            const TearLoad load = trousers(triangles, 1e5);
            CHECK(load.steps > 3);
            CHECK(load.measured == doctest::Approx(load.expected).epsilon(0.05));
        }
    }

    TEST_CASE("a crack in the middle of a pulled sheet: energy release of the handbook") {
        for (const int triangles : {1500, 6000}) {
            const MiddleCrack crack = middle_crack(triangles);
            CHECK(crack.release == doctest::Approx(crack.expected).epsilon(triangles < 3000 ? 0.15 : 0.08));
        }
    }
}
