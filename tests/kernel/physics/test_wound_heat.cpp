// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "flow/chamber.hpp"
#include "physics/anatomy/wound_heat.hpp"
#include "physics/fluid/chamber_flow.hpp"

using namespace rhexis;

namespace {

constexpr double dt = 0.01;

WoundState after(double seconds, double power, double ml_min, WoundState wound = {}) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
        heat_wound(power, ml_min * mm3_s_per_ml_min, dt, wound);
    }
    return wound;
}

}  // namespace

TEST_SUITE("wound heat") {
    TEST_CASE("a loaded sleeve without flow warms by 19 degrees in a second [Zacharias2012]") {
        WoundState cold;
        cold.temperature = 26.0;
        CHECK(after(1.0, 1.0, 0.0, cold).temperature == doctest::Approx(45.0).epsilon(0.03));
    }

    TEST_CASE("with flow it settles where wounds under surgery are, 23 to 32 degrees [Nair2017]") {
        const double running = after(30.0, 0.5, 20.0).temperature;
        CHECK(running > 23.0);
        CHECK(running < 32.0);
        // the same as the balance of the three terms
        CHECK(running == doctest::Approx((20.0 * 0.5 + 0.1 * 34.0 + 4.0 * 24.0) / 4.1).epsilon(1e-6));
    }

    TEST_CASE("it approaches that as an exponential, within what the step allows") {
        const double rate = 4.1;
        const double end = (0.1 * 34.0 + 4.0 * 24.0) / rate;
        const double exact = end + (34.0 - end) * std::exp(-rate * 0.5);
        CHECK(after(0.5, 0.0, 20.0).temperature == doctest::Approx(exact).epsilon(0.005));
    }

    TEST_CASE("without flow it is burnt in a few seconds, and gapes from then on, tool or none") {
        CHECK(burn_share(after(1.0, 1.0, 0.0)) == 0.0);
        const WoundState burnt = after(6.0, 1.0, 0.0);
        CHECK(burn_share(burnt) == 1.0);
        CHECK(wound_gape(burnt, true) == doctest::Approx(3.0));
        CHECK(wound_gape(burnt, false) == doctest::Approx(2.0));
        CHECK(wound_gape(WoundState{}, false) == 0.0);
        CHECK(burn_share(after(60.0, 1.0, 20.0)) == 0.0);         // the twin with flow
        CHECK(burn_share(after(10.0, 0.0, 20.0, burnt)) == 1.0);  // it does not heal
    }

    TEST_CASE("a state that no wound can have is refused") {
        ChamberState state = chamber_state({}, 2000.0, 0.0);
        CHECK(check(ChamberModel{}, state).ok());
        state.wound.temperature = NAN;
        CHECK(check(ChamberModel{}, state).error().text().find("temperature") != std::string::npos);
        state.wound = {34.0, -1.0};
        CHECK_FALSE(check(ChamberModel{}, state).ok());
    }
}
