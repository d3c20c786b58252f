// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tools/advance_tool.hpp"
#include "tools/instruments.hpp"

using namespace rhexis;

TEST_SUITE("tools") {
    TEST_CASE("the spatula ends in an olive that is bent down, and its shaft runs through where the wound holds it") {
        const ToolModel spatula = make_tool("spatula").value();
        CHECK(spatula.name == "spatula");
        const RoundedCone& olive = spatula.parts.at(0);
        const RoundedCone& neck = spatula.parts.at(1);
        const RoundedCone& shaft = spatula.parts.at(2);
        CHECK(olive.a.norm() - olive.radius_a == doctest::Approx(0.0));  // its tip is the origin
        CHECK(olive.b == neck.a);
        CHECK(neck.b == shaft.a);
        CHECK(neck.radius_a < olive.radius_b);
        CHECK(shaft.a.y() > olive.a.y() + 1.5);
        const Vec3 along = (shaft.b - shaft.a).normalized();
        const Vec3 wound(0.0, 0.0, 8.0);
        CHECK((wound - shaft.a).cross(along).norm() < 1e-12);
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
