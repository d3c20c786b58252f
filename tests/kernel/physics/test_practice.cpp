// SPDX-License-Identifier: GPL-3.0-or-later
// Lids under a drape, a pedal in the air, beads between jaws.
#include <doctest/doctest.h>

#include <limits>

#include "physics/anatomy/lids_motion.hpp"
#include "physics/fluid/bead_motion.hpp"

using namespace rhexis;

namespace {

WorldModel with_tool(ToolKind kind) {
    WorldModel world;
    ToolModel tool;
    tool.kind = kind;
    world.tools = {tool};
    return world;
}

ToolState forceps_at(const Vec3& place, double jaw, double previous_jaw) {
    ToolState tool;
    tool.present = true;
    tool.pose.position = tool.previous_pose.position = place;
    tool.jaw = jaw;
    tool.previous_jaw = previous_jaw;
    return tool;
}

WorldModel lids_world(ToolKind kind) {
    WorldModel world = with_tool(kind);
    world.lids = LidsModel{};
    world.lids->infusion_resistance = 100.0;
    return world;
}

WorldModel beads_world() {
    WorldModel world = with_tool(ToolKind::forceps);
    world.beads = BeadsModel{};
    world.beads->start = {Vec3(2.0, 0.0, 0.0), Vec3(2.2, 0.0, 0.0)};
    return world;
}

}  // namespace

TEST_CASE("a drape covers what is in its reach when it is pressed, and nothing comes off") {
    const WorldModel world = lids_world(ToolKind::drape);
    LidsState lids = rest_state(*world.lids);
    CHECK(lids.covered.size() == 24);
    const Vec3 place = lash_place(*world.lids, 0.0, 3);
    move_lids(world, std::vector{forceps_at(place, 0.49, 0.0)}, 0.01, lids);
    CHECK(covered_share(lids) == 0.0);
    move_lids(world, std::vector{forceps_at(place + Vec3(0.0, 0.0, 1.7), 1.0, 0.0)}, 0.01, lids);
    CHECK(covered_share(lids) == 0.0);
    move_lids(world, std::vector{forceps_at(place, 0.5, 0.0)}, 0.01, lids);
    CHECK(lids.covered[3] == 1);
    CHECK(covered_share(lids) == doctest::Approx(1.0 / 24.0));
    move_lids(world, std::vector{forceps_at(Vec3(0.0, 0.0, 50.0), 0.0, 0.0)}, 1e6, lids);
    CHECK(covered_share(lids) == doctest::Approx(1.0 / 24.0));
    for (int i = 0; i < 24; ++i) {
        move_lids(world, std::vector{forceps_at(lash_place(*world.lids, 0.0, i), 1.0, 1.0)}, 0.01, lids);
    }
    CHECK(covered_share(lids) == 1.0);
}

TEST_CASE("margins are symmetric and open as far as the speculum lets them") {
    const WorldModel world = lids_world(ToolKind::speculum);
    LidsState lids = rest_state(*world.lids);
    for (const double jaw : {0.4, 0.2}) {
        move_lids(world, std::vector{forceps_at(Vec3(0.0, 0.0, 5.0), jaw, 0.0)}, 0.01, lids);
        CHECK(lids.opening == 0.4);  // it stays
    }
    move_lids(world, std::vector{forceps_at(Vec3(7.0, 0.0, 5.0), 1.0, 0.0)}, 0.01, lids);
    CHECK(lids.opening == 0.4);  // beside the eye
    move_lids(world, std::vector{forceps_at(Vec3(0.0, 0.0, 5.0), 7.0, 0.0)}, 0.01, lids);
    CHECK(lids.opening == 1.0);
    for (int i = 0; i < 12; ++i) {
        const Vec3 near = lash_place(*world.lids, 1.0, i);
        const Vec3 far = lash_place(*world.lids, 1.0, i + 12);
        CHECK(near.y() == -far.y());
        CHECK(near.x() == doctest::Approx(-lash_place(*world.lids, 1.0, 11 - i).x()));
        CHECK(std::abs(near.y()) <= world.lids->opened);
    }
}

TEST_CASE("a pedal is tested in the air, position by position, by what flows") {
    const WorldModel world = lids_world(ToolKind::phaco);
    LidsState lids = rest_state(*world.lids);
    ToolState tip = forceps_at(Vec3(0.0, 0.0, 10.0), 0.0, 0.0);
    tip.irrigation = true;
    tip.bottle_height = 750.0;
    move_lids(world, std::vector{tip}, 0.1, lids);
    CHECK(lids.drip == doctest::Approx(750.0 * 9.81 / 100.0));
    CHECK(lids.tested[0] == doctest::Approx(0.1));
    tip.aspiration = 0.5;
    tip.pump_flow = 100.0;
    move_lids(world, std::vector{tip}, 0.1, lids);
    tip.power = 0.3;
    move_lids(world, std::vector{tip}, 0.2, lids);
    CHECK(lids.tested[0] == doctest::Approx(0.1));
    CHECK(lids.tested[1] == doctest::Approx(0.1));
    CHECK(lids.tested[2] == doctest::Approx(0.2));
    tip.pose.position.z() = 5.0;  // on the eye
    move_lids(world, std::vector{tip}, 0.2, lids);
    CHECK(lids.tested[2] == doctest::Approx(0.2));
    CHECK(lids.drip == 0.0);
    tip.pose.position.z() = 10.0;
    tip.bottle_height = 0.0;  // the line is shut
    move_lids(world, std::vector{tip}, 0.2, lids);
    CHECK(lids.drip == 0.0);
}

TEST_CASE("jaws that close take the nearest bead, carry it, and let it go in the tray or beside it") {
    const WorldModel world = beads_world();
    BeadsState beads = rest_state(*world.beads);
    const Vec3 tip(1.9, 0.0, 0.0);
    move_beads(world, std::vector{forceps_at(tip, 0.0, 0.0)}, 0.01, beads);
    CHECK(beads.grasps == 0);  // closed jaws take none
    move_beads(world, std::vector{forceps_at(tip, 0.2, 0.6)}, 0.01, beads);
    CHECK(beads.grasps == 1);
    CHECK(beads.beads[0].tool == 0);
    CHECK(beads.beads[1].tool == -1);
    move_beads(world, std::vector{forceps_at(Vec3(0.5, 0.0, 1.0), 0.0, 0.2)}, 0.01, beads);
    CHECK((beads.beads[0].position - Vec3(0.6, 0.0, 1.0)).norm() < 1e-12);
    CHECK(placed_beads(*world.beads, beads) == 0);
    move_beads(world, std::vector{forceps_at(Vec3(0.5, 0.0, 1.0), 0.6, 0.0)}, 0.01, beads);
    CHECK(beads.beads[0].tool == -1);
    CHECK(beads.drops == 0);
    move_beads(world, std::vector{forceps_at(Vec3(0.5, 0.0, 1.0), 0.6, 0.6)}, 5.0, beads);
    CHECK(beads.beads[0].position.z() == world.beads->floor);
    CHECK(placed_beads(*world.beads, beads) == 1);
}

TEST_CASE("a bead is lost by a jerk, by leaving, and never sinks through the floor or out of the eye") {
    const WorldModel world = beads_world();
    for (const bool leaves : {false, true}) {
        BeadsState beads = rest_state(*world.beads);
        move_beads(world, std::vector{forceps_at(Vec3(2.0, 0.0, 0.0), 0.0, 0.6)}, 0.01, beads);
        REQUIRE(beads.beads[0].tool == 0);
        ToolState tip = forceps_at(Vec3(20.0, 0.0, 4.0), 0.0, 0.0);
        move_beads(world, std::vector{tip}, 0.01, beads);
        CHECK(beads.beads[0].position.x() == 20.0);
        tip.present = !leaves;
        tip.velocity = Vec3(leaves ? 0.0 : 12.1, 0.0, 0.0);
        move_beads(world, std::vector{tip}, 0.01, beads);
        CHECK(beads.drops == 1);
        move_beads(world, std::vector{tip}, 1e9, beads);
        CHECK(beads.beads[0].position.z() == world.beads->floor);
        CHECK(beads.beads[0].position.x() == doctest::Approx(world.beads->wall));
    }
}

TEST_CASE("a speed that is not a number loses the bead and leaves its place finite") {
    const WorldModel world = beads_world();
    BeadsState beads = rest_state(*world.beads);
    move_beads(world, std::vector{forceps_at(Vec3(2.0, 0.0, 0.0), 0.0, 0.6)}, 0.01, beads);
    ToolState tip = forceps_at(Vec3(2.0, 0.0, 0.5), 0.0, 0.0);
    tip.velocity.setConstant(std::numeric_limits<double>::quiet_NaN());
    move_beads(world, std::vector{tip}, 0.01, beads);
    CHECK(beads.beads[0].tool == -1);
    CHECK(beads.beads[0].position.allFinite());
}
