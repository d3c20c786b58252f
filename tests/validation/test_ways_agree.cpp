// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit and the implicit way solve the same equations: at rest they give the same, whatever the step.
#include <doctest/doctest.h>

#include <cmath>

#include "scenes/contact_trials.hpp"

using namespace rhexis;

TEST_SUITE("validation") {
    TEST_CASE("a ball pressed into a block feels the same both ways, within 1 % at every step") {
        const scenes::Press reference = scenes::press(Advance::explicit_, 0.001);
        CHECK(scenes::press(Advance::explicit_, 0.01).force == doctest::Approx(reference.force).epsilon(0.001));
        for (const double dt : {0.02, 0.01, 0.005, 0.002, 0.001}) {
            const scenes::Press found = scenes::press(Advance::implicit, dt);
            const double force = std::abs(found.force / reference.force - 1.0);
            const double dip = std::abs(found.dip / reference.dip - 1.0);
            MESSAGE("steps of " << 1e3 * dt << " ms: force " << 100.0 * force << " %, dip " << 100.0 * dip
                                << " % from the explicit way");
            CHECK(force < 0.01);
            CHECK(dip < 0.01);
        }
    }
}
