// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tools/advance_tool.hpp"
#include "tools/instruments.hpp"

using namespace rhexis;

TEST_SUITE("tools") {
    TEST_CASE("the hook ends in a short round point at a right angle to its thin shaft") {
        const ToolModel hook = make_tool("hook").value();
        CHECK(hook.name == "hook");
        CHECK(hook.kind == ToolKind::probe);
        const RoundedCone& point = hook.parts.at(0);
        const RoundedCone& shaft = hook.parts.at(1);
        CHECK(point.a.norm() == doctest::Approx(point.radius_a));  // its tip is the origin
        CHECK(point.radius_a == 0.1);
        CHECK(point.b == shaft.a);
        CHECK((point.b - point.a).norm() == doctest::Approx(0.4));
        CHECK(shaft.radius_a == 0.15);
        CHECK(shaft.radius_b == 0.15);
        const double cosine = (point.b - point.a).normalized().dot((shaft.b - shaft.a).normalized());
        CHECK(std::abs(cosine) < 0.11);
        CHECK(hook.friction > 0.0);
    }

    TEST_CASE("a hook at 0.5 mm over a place has its tip there and its shaft beside and over it") {
        const ToolModel hook = make_tool("hook").value();
        DeviceSample sample;
        sample.present = true;
        sample.pose.position = Vec3(1.0, 2.0, 0.5);
        const ToolState state = next_tool(hook, ToolState{}, sample, 0.01, ToolSettings{}).state;
        CHECK(state.pose.to_world(Vec3::Zero()) == sample.pose.position);
        CHECK(state.pose.to_world(hook.parts.at(1).b).y() < -20.0);
    }

    TEST_CASE("an unknown instrument near it is told its name") {
        CHECK(make_tool("hok").error().text().find("did you mean hook") != std::string::npos);
    }
}
