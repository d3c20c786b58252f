// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "math/rotation.hpp"
#include "physics/anatomy/globe_roll.hpp"

using namespace rhexis;

namespace {

constexpr double dt = 0.01;

/// A globe of which the main wound lies at y = -5, 12 mm before its middle, and a straight instrument.
WorldModel world() {
    WorldModel model;
    model.globe = GlobeModel{};
    model.globe->front_centre = Vec3(0.0, 0.0, 6.0);
    model.globe->lips = {Vec3(0.0, -5.0, 12.0), Vec3(-5.0, 0.0, 12.0)};
    model.globe->widths = {2.4, 1.0};
    ToolModel tool;
    tool.parts = {{Vec3(0.0, 0.0, 0.1), Vec3(0.0, 0.0, 60.0), 0.1, 0.1}};
    model.tools = {tool, tool};
    return model;
}

/// Its tip at a place, its shaft through another.
ToolState held(const Vec3& tip, const Vec3& through) {
    ToolState tool;
    tool.present = true;
    tool.pose.position = tip;
    tool.pose.orientation = turn_of_z(through - tip);
    return tool;
}

/// As hands in the room hold them.
void hold(const WorldModel& model, const std::vector<ToolState>& room, double seconds, WorldState& state) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
        std::vector<ToolState> tools = room;
        for (ToolState& tool : tools) {
            tool.pose = to_eye(*model.globe, *state.globe, tool.pose);
        }
        roll_globe(model, tools, dt, state);
    }
}

WorldState at_rest(const WorldModel& model) {
    WorldState state;
    state.globe = GlobeState{};
    state.tips.resize(model.tools.size());
    return state;
}

const Vec3 over_lens(0.0, 0.0, 11.0);

}  // namespace

TEST_SUITE("globe") {
    TEST_CASE("a shaft through the middle of its wound turns nothing") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        hold(model, {held(over_lens, model.globe->lips[0]), ToolState{}}, 1.0, state);
        CHECK(roll_angle(*state.globe) < 1e-12);
        CHECK(state.globe->lips[0].excursion < 1e-9);
        CHECK(state.globe->lips[0].enlargement == 0.0);
    }

    TEST_CASE("a small shift to the side is shared as by two springs in a row") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        const double shift = 0.1;
        hold(model, {held(over_lens, model.globe->lips[0] + Vec3(shift, 0.0, 0.0)), ToolState{}}, 3.0, state);
        const double arm = model.globe->lips[0].norm();  // the pull is along x, across the way to the lip
        const double orbit = model.globe->stiffness / (arm * arm);
        const double share = model.globe->lip_stiffness / (model.globe->lip_stiffness + orbit);
        const Lip& lip = state.globe->lips[0];
        CHECK(lip.excursion == doctest::Approx(shift).epsilon(0.03));
        CHECK(lip.deflection.norm() == doctest::Approx((1.0 - share) * shift).epsilon(0.05));
        CHECK(roll_angle(*state.globe) == doctest::Approx(share * shift / arm).epsilon(0.05));
        CHECK(lip.enlargement == 0.0);
    }

    TEST_CASE("the cornea gives way first, the globe follows") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        const std::vector<ToolState> tools{held(over_lens, model.globe->lips[0] + Vec3(0.2, 0.0, 0.0)), ToolState{}};
        hold(model, tools, dt, state);
        const double at_once = state.globe->lips[0].deflection.norm();
        hold(model, tools, 1.0, state);
        CHECK(at_once > 1.5 * state.globe->lips[0].deflection.norm());
    }

    TEST_CASE("without a shaft it comes back as an implicit exponential") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        state.globe->roll = Vec3(0.1, 0.0, 0.0);
        hold(model, {ToolState{}, ToolState{}}, 0.2, state);
        CHECK(state.globe->roll.x() == doctest::Approx(0.1 * std::pow(1.0 / (1.0 + dt / model.globe->lag), 20)));
    }

    TEST_CASE("what is stretched beyond what a lip bears stays, and grows no more when the shaft comes back") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        hold(model, {held(over_lens, model.globe->lips[0] + Vec3(2.5, 0.0, 0.0)), ToolState{}}, 1.0, state);
        const double stretched = state.globe->lips[0].enlargement;
        CHECK(stretched > 0.1);
        hold(model, {held(over_lens, model.globe->lips[0]), ToolState{}}, 1.0, state);
        CHECK(state.globe->lips[0].enlargement == stretched);
        CHECK(roll_angle(*state.globe) < 0.01);
    }

    TEST_CASE("a wound is widened by what stays") {
        WorldModel model = world();
        model.wounds = WoundsModel{};
        WorldState state = at_rest(model);
        state.wounds = WoundsState{};
        Wound& wound = state.wounds->wounds[main_wound];
        wound.cut = true;
        wound.inner = model.globe->lips[0];
        wound.width = 2.4;
        hold(model, {held(over_lens, model.globe->lips[0] + Vec3(2.5, 0.0, 0.0)), ToolState{}}, 1.0, state);
        CHECK(wound.width == doctest::Approx(2.4 + state.globe->lips[0].enlargement));
    }

    TEST_CASE("what stands outside, or passes no wound, turns nothing") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        const Vec3 outside(0.0, -9.0, 14.0);
        hold(model, {held(outside, outside + Vec3(1.0, -4.0, 2.0)), held(over_lens, Vec3(5.0, 5.0, 12.0))}, 0.5, state);
        CHECK(roll_angle(*state.globe) < 1e-12);
    }

    TEST_CASE("a huge step and a wild shaft leave it finite and within what the orbit allows") {
        const WorldModel model = world();
        WorldState state = at_rest(model);
        const std::vector<ToolState> tools{held(over_lens, model.globe->lips[0] + Vec3(3.9, 0.0, 0.0)),
                                           held(over_lens, model.globe->lips[1] + Vec3(0.0, -3.9, 0.0))};
        roll_globe(model, tools, 1e6, state);
        CHECK(state.globe->roll.allFinite());
        CHECK(state.globe->roll.norm() <= model.globe->most + 1e-12);
    }

    TEST_CASE("room and eye are each other's inverse") {
        const WorldModel model = world();
        GlobeState globe;
        globe.roll = Vec3(0.1, -0.2, 0.05);
        const Pose pose{Vec3(1.0, 2.0, 3.0), Quat(0.5, 0.5, -0.5, 0.5)};
        const Pose back = to_eye(*model.globe, globe, to_room(*model.globe, globe, pose));
        CHECK((back.position - pose.position).norm() < 1e-12);
        CHECK(back.orientation.angularDistance(pose.orientation) < 1e-7);
        CHECK(roll_angle(globe) == doctest::Approx(rotation_of(globe).angularDistance(Quat::Identity())));
    }

    TEST_CASE("a lip that is pressed opens its wound, with the third power of the slit, as wide as it goes") {
        const GlobeModel model;
        Lip lip;
        lip.deflection = Vec3(0.5 * model.opens, 0.0, 0.0);
        CHECK(pressed_conductance(model, lip, 1.0, 1.5) == 0.0);
        lip.deflection = Vec3(0.0, 0.0, -0.15);
        const double slit = model.opening * (0.15 - model.opens);
        CHECK(pressed_conductance(model, lip, 1.0, 1.5) ==
              doctest::Approx(slit * slit * slit / (12.0 * model.viscosity * 1.5)));
        lip.deflection = Vec3(0.0, 0.0, -50.0);
        CHECK(pressed_conductance(model, lip, 1.0, 0.0) ==
              doctest::Approx(std::pow(model.widest, 3) / (12.0 * model.viscosity * 0.3)));
    }
}
