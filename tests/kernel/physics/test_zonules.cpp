// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "eye/capsular_bag.hpp"
#include "mesh/half_ellipsoids.hpp"
#include "physics/anatomy/bag_motion.hpp"
#include "physics/anatomy/zonule_loss.hpp"

using namespace rhexis;

namespace {

constexpr double dt = 0.01;

struct Bag {
    BagModel model;
    BagState state;
};

/// lost: meridians from +x on against the clock without zonules.
Bag bag_without(int lost) {
    Bag bag;
    bag.model = make_bag({4.6, 1.9, 2.7}, 0.2, 68.0);
    ZonuleModel zonules;
    zonules.lost.assign(bag.model.zonules.size(), 0);
    for (int i = 0; i < 2 * lost; ++i) {
        zonules.lost[static_cast<std::size_t>(i)] = 1;
    }
    bag.model.breakable = zonules;
    bag.state.zonules = rest_state(zonules);
    return bag;
}

void settle(Bag& bag, int steps = 4000) {
    for (int i = 0; i < steps; ++i) {
        accelerate_bag(bag.model, 1e-3, bag.state);
        move_bag(1e-3, bag.state);
    }
}

ToolModel tool_of(ToolKind kind) {
    ToolModel tool;
    tool.kind = kind;
    return tool;
}

ToolState forceps_at(const Vec3& place, double jaw, double before) {
    ToolState tool;
    tool.present = true;
    tool.pose.position = place;
    tool.jaw = jaw;
    tool.previous_jaw = before;
    return tool;
}

Vec3 rim_of(const BagModel& bag, double x_share, double y_share) {
    const double share = bag.opening_radius / bag.shape.radius;
    return {bag.opening_radius * x_share, bag.opening_radius * y_share,
            bag.shape.anterior * std::sqrt(1.0 - share * share)};
}

Vec6 wrench_of(const Bag& bag) { return suspension_wrench(bag.model, bag.state, bag.state.pose); }

}  // namespace

TEST_SUITE("zonules") {
    TEST_CASE("whole zonules pull as those that cannot break") {
        Bag bag = bag_without(0);
        bag.state.pose.position = Vec3(0.2, -0.1, 0.15);
        BagModel plain = bag.model;
        plain.breakable.reset();
        BagState other = bag.state;
        other.zonules.reset();
        CHECK(wrench_of(bag) == suspension_wrench(plain, other, other.pose));
        CHECK(lost_deg(bag.model, *bag.state.zonules) == 0.0);
        CHECK(widest_gap(bag.model, *bag.state.zonules).width_deg == 0.0);
        CHECK(unsupported_deg(bag.model, *bag.state.zonules) == 0.0);
    }

    TEST_CASE("at rest the bag lacks what the lost ones held, and goes away from the gap") {
        Bag bag = bag_without(6);
        Vec3 missing = Vec3::Zero();
        for (std::size_t i = 0; i < 12; ++i) {
            missing += missing_pull(bag.model, i, 0.0);
        }
        CHECK((wrench_of(bag).head<3>() - missing).norm() < 1e-9 * missing.norm());
        const ZonuleGap gap = widest_gap(bag.model, *bag.state.zonules);
        CHECK(gap.width_deg == doctest::Approx(90.0));
        CHECK(missing.dot(gap.middle) < -1000.0);
        settle(bag);
        CHECK(wrench_of(bag).head<3>().norm() < 1e-3 * missing.norm());
        CHECK(bag.state.pose.position.dot(gap.middle) < -0.1);
        CHECK((bag.state.pose.orientation * Vec3::UnitZ()).z() < 1.0 - 1e-5);
    }

    TEST_CASE("the gap goes round the seam, and past half the ring its middle is on the side that is lost") {
        Bag bag = bag_without(0);
        std::vector<std::uint8_t>& broken = bag.state.zonules->broken;
        for (const std::size_t meridian : {23U, 0U, 1U}) {
            broken[2 * meridian] = broken[2 * meridian + 1] = 1;
        }
        ZonuleGap gap = widest_gap(bag.model, *bag.state.zonules);
        CHECK(gap.width_deg == doctest::Approx(45.0));
        CHECK((gap.middle - Vec3::UnitX()).norm() < 1e-9);
        bag = bag_without(17);  // from 0 to 240 degrees
        gap = widest_gap(bag.model, *bag.state.zonules);
        CHECK(gap.width_deg == doctest::Approx(255.0));
        CHECK(gap.middle.dot(Vec3(-0.5, std::sqrt(0.75), 0.0)) > 0.999);
        bag = bag_without(24);
        CHECK(widest_gap(bag.model, *bag.state.zonules).width_deg == doctest::Approx(360.0));
    }

    TEST_CASE("the most stretched one breaks, one a step, and none that is stretched less") {
        Bag bag = bag_without(0);
        bag.model.breakable->breaks_at = 0.5;
        const std::vector<ToolModel> models;
        const std::vector<ToolState> tools;
        bag.state.pose.position = Vec3(0.5, 0.0, 0.0);
        tend_zonules(bag.model, models, tools, dt, bag.state);
        CHECK(lost_deg(bag.model, *bag.state.zonules) == 0.0);
        bag.state.pose.position = Vec3(2.0, 0.0, 0.0);
        for (int step = 1; step <= 5; ++step) {
            tend_zonules(bag.model, models, tools, dt, bag.state);
            CHECK(lost_deg(bag.model, *bag.state.zonules) == doctest::Approx(7.5 * step));
        }
        CHECK(bag.state.zonules->broken[0] == 0);  // before the bag, towards which it went
        for (int step = 0; step < 200; ++step) {
            tend_zonules(bag.model, models, tools, dt, bag.state);
        }
        CHECK(lost_deg(bag.model, *bag.state.zonules) < 200.0);
    }

    TEST_CASE("a ring shares the load out up to 120 degrees, and not at all from 180 on") {
        for (const int lost : {4, 8, 10, 12, 16}) {
            Bag bag = bag_without(lost);
            const double without = wrench_of(bag).head<2>().norm();
            bag.state.zonules->ring = 0.99;
            CHECK(wrench_of(bag).head<2>().norm() == without);
            bag.state.zonules->ring = 1.0;
            const double with = wrench_of(bag).head<2>().norm();
            const double expected = std::clamp((180.0 - 15.0 * lost) / 60.0, 0.0, 1.0);
            CHECK(bridged_share(bag.model, *bag.state.zonules) == doctest::Approx(expected));
            CHECK(with == doctest::Approx((1.0 - expected) * without).epsilon(1e-9));
            CHECK(unsupported_deg(bag.model, *bag.state.zonules) == doctest::Approx(15.0 * lost * (1.0 - expected)));
        }
    }

    TEST_CASE("a ring bears no more than the zonules that are left") {
        Bag bag = bag_without(8);
        const Vec3 shift(0.0, 0.0, 0.01);
        const auto stiffness = [&] {
            bag.state.pose.position.setZero();
            const double rest = wrench_of(bag).z();
            bag.state.pose.position = shift;
            return (rest - wrench_of(bag).z()) / shift.z();
        };
        const double without = stiffness();
        bag.state.zonules->ring = 1.0;
        CHECK(stiffness() == doctest::Approx(without).epsilon(1e-6));
    }

    TEST_CASE("a hook stays where the hand lets go of it on the edge, pulls towards the limbus, and only pulls") {
        Bag bag = bag_without(6);
        settle(bag);
        const double before = bag.state.pose.position.norm();
        const Vec3 gap = widest_gap(bag.model, *bag.state.zonules).middle;
        const std::vector<ToolModel> models{tool_of(ToolKind::capsule_hook)};
        const Vec3 rim = bag.state.pose.to_world(rim_of(bag.model, gap.x(), gap.y()));
        tend_zonules(bag.model, models, std::vector{forceps_at(rim + Vec3(0.0, 0.0, 0.9), 0.0, 1.0)}, dt, bag.state);
        CHECK(bag.state.zonules->hooks.empty());
        tend_zonules(bag.model, models, std::vector{forceps_at(rim, 1.0, 1.0)}, dt, bag.state);
        CHECK(bag.state.zonules->hooks.empty());
        tend_zonules(bag.model, models, std::vector{forceps_at(rim, 0.0, 1.0)}, dt, bag.state);
        REQUIRE(bag.state.zonules->hooks.size() == 1);
        const CapsuleHook hook = bag.state.zonules->hooks[0];
        const Vec3 pull = hook_force(*bag.model.breakable, hook, bag.state.pose);
        CHECK(pull.norm() == doctest::Approx(bag.model.breakable->hook_pull));
        CHECK(pull.dot(gap) > 0.6 * pull.norm());  // the limbus lies deeper than the edge that has come up
        settle(bag);
        CHECK(bag.state.pose.position.norm() < before);
        CHECK(unsupported_deg(bag.model, *bag.state.zonules) < 90.0);
        Pose there = bag.state.pose;
        there.position += 3.0 * gap;
        CHECK(hook_force(*bag.model.breakable, hook, there).norm() == 0.0);
        CHECK(hook_stiffness(*bag.model.breakable, hook, there).norm() == 0.0);
        for (int i = 0; i < 9; ++i) {
            tend_zonules(bag.model, models, std::vector{forceps_at(rim_of(bag.model, 1.0, 0.0), 0.0, 1.0)}, dt,
                         bag.state);
        }
        CHECK(bag.state.zonules->hooks.size() <= bag.model.breakable->most_hooks);
    }

    TEST_CASE("a ring goes in as fast as a hand feeds it, at the opening only, and stays") {
        Bag bag = bag_without(4);
        const std::vector<ToolModel> models{tool_of(ToolKind::ring)};
        const Vec3 rim = rim_of(bag.model, 0.0, 1.0);
        tend_zonules(bag.model, models, std::vector{forceps_at(Vec3(0.0, 0.0, 3.0), 1.0, 1.0)}, dt, bag.state);
        CHECK(bag.state.zonules->ring == 0.0);
        for (int i = 0; i < 100; ++i) {
            tend_zonules(bag.model, models, std::vector{forceps_at(rim, 1.0, 1.0)}, dt, bag.state);
        }
        CHECK(bag.state.zonules->ring == doctest::Approx(100 * dt / 2.0));
        tend_zonules(bag.model, models, std::vector{forceps_at(rim, 0.2, 1.0)}, dt, bag.state);
        CHECK(bag.state.zonules->ring == doctest::Approx(0.5));
        tend_zonules(bag.model, models, std::vector{forceps_at(rim, 1.0, 1.0)}, 1e6, bag.state);
        CHECK(bag.state.zonules->ring == 1.0);
    }

    TEST_CASE("stiffness of what holds is the change of its force") {
        Bag bag = bag_without(5);
        const std::vector<ToolModel> models{tool_of(ToolKind::capsule_hook)};
        tend_zonules(bag.model, models, std::vector{forceps_at(rim_of(bag.model, 0.6, 0.8), 0.0, 1.0)}, dt, bag.state);
        REQUIRE(bag.state.zonules->hooks.size() == 1);
        const RigidTerm term = bag_term(bag.model, bag.state, Pose{}, Vec6::Zero(), dt);
        const double drag = bag.model.damping / dt;
        for (int axis = 0; axis < 3; ++axis) {
            Pose moved;
            moved.position[axis] = 1e-6;
            const double change = (suspension_wrench(bag.model, bag.state, Pose{}) -
                                   suspension_wrench(bag.model, bag.state, moved))[axis] /
                                  1e-6;
            // that a hook's line turns adds to its change of force, and is left out of the stiffness
            const CapsuleHook& hook = bag.state.zonules->hooks[0];
            const double along = ((hook.at_limbus - hook.on_bag) / hook.length)[axis];
            const double turning = bag.model.breakable->hook_pull / hook.length * (1.0 - along * along);
            CHECK(term.stiffness(axis, axis) - drag == doctest::Approx(change - turning).epsilon(1e-3));
        }
    }
}
