// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <limits>

#include "support/sample.hpp"
#include "tools/microscope.hpp"

using namespace rhexis;
using rhexis::test::sample_at;

namespace {

constexpr double dt = 0.01;

DeviceSample sent_to(const Vec3& place) { return sample_at(0, place); }

}  // namespace

TEST_SUITE("microscope") {
    TEST_CASE("it nears where it is sent in a straight line at its motors' speed, and stands there exactly") {
        MicroscopeState state{Vec3(1.0, 1.0, 3.0)};
        const Vec3 goal(1.6, 1.8, 2.9);
        int steps = 0;
        while (state.position != goal && steps < 100) {
            const Vec3 before = state.position;
            state = next_microscope(state, sent_to(goal), dt).state;
            const Vec3 moved = state.position - before;
            CHECK(moved.head<2>().norm() <= microscope_across_speed * dt + 1e-12);
            CHECK(std::abs(moved.z()) <= microscope_focus_speed * dt + 1e-12);
            CHECK(std::abs(moved.x() * 0.8 - moved.y() * 0.6) < 1e-12);
            ++steps;
        }
        CHECK(steps == 25);  // 1 mm across at 4 mm/s; 0.1 mm of focus takes less
    }

    TEST_CASE("off the pedal it stays, and so it does when it is sent nowhere") {
        const MicroscopeState state{Vec3(1.0, 2.0, 3.0)};
        DeviceSample sample = sent_to(Vec3::Zero());
        sample.present = false;
        CHECK(next_microscope(state, sample, dt).state.position == state.position);
        CHECK(next_microscope(state, sample, dt).rejected.empty());
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            const MicroscopeStep step = next_microscope(state, sent_to(Vec3(0.0, bad, 0.0)), dt);
            CHECK(step.state.position == state.position);
            CHECK(step.rejected == "a number is not finite");
        }
        const MicroscopeStep far = next_microscope(state, sent_to(Vec3(0.0, -30.0, 0.0)), dt);
        CHECK(far.state.position == state.position);
        CHECK(far.rejected == "microscope sent 30 mm from the eye, allowed 25 mm");
    }
}
