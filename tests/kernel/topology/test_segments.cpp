// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "mesh/places.hpp"
#include "scenes/bodies.hpp"
#include "topology/remove.hpp"
#include "topology/segments.hpp"

using namespace rhexis;

TEST_SUITE("segments") {
    TEST_CASE("trenches: open along the cuts down to the back of the nucleus, mass counted, the state valid") {
        const EyeModel eye = scenes::default_eye(1000);
        const SolidModel& lens = eye.lens;
        SolidState state = rest_state(lens);
        const double whole = remaining_mass(lens, state);
        const MeshEdit edit = trench(lens, state, 0, 4, 1.2);
        const double mass = edit_mass(edit, lens, state);
        apply(edit, lens, state);
        CHECK(validate(lens, state).ok());
        CHECK(remaining_mass(lens, state) + mass == doctest::Approx(whole).epsilon(1e-12));
        CHECK(mass > 0.1 * whole);
        CHECK(mass < 0.4 * whole);
        for (int t = 0; t < static_cast<int>(lens.fine.tets.size()); ++t) {
            const Vec3 place = fine_middle(lens.fine, lens.coarse.nodes, t);
            const double off = std::min(std::abs(place.x()), std::abs(place.y()));
            if (off > 0.6 || place.head<2>().norm() > 4.0) {
                CHECK(state.fraction[t] == 1.0);
            } else if (place.z() > 0.0 && place.head<2>().norm() < 3.0) {
                CHECK(state.fraction[t] == 0.0);
            }
        }
    }

    TEST_CASE("no trench of no width, none without cuts, a wider one takes more") {
        const EyeModel eye = scenes::default_eye(500);
        const SolidModel& lens = eye.lens;
        const SolidState state = rest_state(lens);
        CHECK(trench(lens, state, 0, 4, 0.0).empty());
        CHECK(trench(lens, state, 0, 0, 1.0).empty());
        CHECK(trench(lens, state, 0, 4, 2.0).removed_fine.size() > trench(lens, state, 0, 4, 1.0).removed_fine.size());
    }
}
