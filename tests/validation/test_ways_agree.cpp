// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit and the implicit way solve the same equations: what they give comes together as the step goes to zero.
#include <doctest/doctest.h>

#include <cmath>

#include "scenes/contact_trials.hpp"

using namespace rhexis;

TEST_SUITE("validation") {
    TEST_CASE("a ball pressed into a block feels the same both ways, within 1 % as the step goes to zero") {
        const scenes::Press reference = scenes::press(Advance::explicit_, 0.001);
        CHECK(scenes::press(Advance::explicit_, 0.01).force == doctest::Approx(reference.force).epsilon(0.001));
        double last_force = 1.0;
        double last_dip = 1.0;
        for (const double dt : {0.01, 0.005, 0.002, 0.001}) {
            const scenes::Press found = scenes::press(Advance::implicit, dt);
            const double force = std::abs(found.force / reference.force - 1.0);
            const double dip = std::abs(found.dip / reference.dip - 1.0);
            MESSAGE("steps of " << 1e3 * dt << " ms: force " << 100.0 * force << " %, dip " << 100.0 * dip
                                << " % from the explicit way");
            CHECK(force < last_force);
            CHECK(dip < last_dip);
            last_force = force;
            last_dip = dip;
        }
        CHECK(last_force < 0.01);
        CHECK(last_dip < 0.01);
    }
}
