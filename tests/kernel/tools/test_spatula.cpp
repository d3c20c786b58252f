// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tools/advance_tool.hpp"
#include "tools/instruments.hpp"

using namespace rhexis;

TEST_SUITE("tools") {
    TEST_CASE("the spatula is thin, blunt and bent down, and its foremost point is its origin") {
        const ToolModel spatula = make_tool("spatula").value();
        CHECK(spatula.name == "spatula");
        const RoundedCone& end = spatula.parts.at(0);
        const RoundedCone& shaft = spatula.parts.at(1);
        CHECK(end.a.z() - end.radius_a == doctest::Approx(0.0));
        CHECK(end.radius_a <= 0.25);
        CHECK(shaft.radius_a == doctest::Approx(0.25));
        CHECK(end.b == shaft.a);
        CHECK(end.a.y() < shaft.a.y());
        CHECK(spatula.friction > 0.0);
    }

    TEST_CASE("a pedal does nothing for the spatula") {
        const ToolModel spatula = make_tool("spatula").value();
        DeviceSample sample;
        sample.present = true;
        sample.pose.position = Vec3(0.0, 0.0, 3.0);
        sample.pedal = 3.0;
        const ToolState state = next_tool(spatula, ToolState{}, sample, 0.01, ToolSettings{}).state;
        CHECK(state.present);
        CHECK_FALSE(state.irrigation);
        CHECK(state.aspiration == 0.0);
        CHECK(state.power == 0.0);
    }
}
