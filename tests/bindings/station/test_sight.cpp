// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/sight.hpp"

#include <doctest/doctest.h>

#include "desk_scene.hpp"

using namespace rhexis;
using namespace rhexis::station;

TEST_SUITE("sight") {
    TEST_CASE("what a cursor is on lies under it, at any depth, behind the cornea and before it") {
        const EyeAnatomy eye = an_eye();
        const GlobeModel model;
        GlobeState rolled;
        rolled.roll = Vec3(0.05, -0.03, 0.01);
        for (const GlobeState* globe :
             {static_cast<const GlobeState*>(nullptr), const_cast<const GlobeState*>(&rolled)}) {
            const Sight sight(above(), &eye, globe != nullptr ? &model : nullptr, globe);
            for (const bool inside : {false, true}) {
                for (const Vec3& place : {Vec3(0.0, 0.0, 0.0), Vec3(3.0, -2.0, 1.5), Vec3(-4.0, 4.0, -2.5)}) {
                    const Vec3 again = sight.under(sight.cursor_on(place, inside), place.z(), inside);
                    CHECK((again - place).norm() < 1e-6);
                }
            }
        }
    }

    TEST_CASE("heights of the picture: the field is one, to the right and up are positive; the cornea enlarges") {
        const EyeAnatomy eye = an_eye();
        const Sight sight(above(), &eye, nullptr, nullptr);
        CHECK(sight.cursor_on(Vec3(7.3, 0.0, 0.0), false).x() == doctest::Approx(0.5));
        CHECK(sight.cursor_on(Vec3(0.0, 7.3, 0.0), false).y() == doctest::Approx(0.5));
        // 4 mm behind the apex: n / (n - P d), and nearer to the camera by what the depth seems less
        const double larger =
            sight.cursor_on(Vec3(1.0, 0.0, 0.0), true).x() / sight.cursor_on(Vec3(1.0, 0.0, 0.0), false).x();
        CHECK(larger == doctest::Approx(1.336 / (1.336 - 0.336 / 7.63 * 4.0)).epsilon(0.01));
    }
}
