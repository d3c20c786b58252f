// SPDX-License-Identifier: GPL-3.0-or-later
// How an implant lies and what its bag bears, of states made by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "eye/implant.hpp"
#include "eye/make_eye.hpp"
#include "mesh/shapes.hpp"
#include "observe/observer.hpp"
#include "tools/injector.hpp"
#include "tools/instruments.hpp"
#include "topology/tear.hpp"

using namespace rhexis;

namespace {

constexpr double equator = 4.8;  ///< radius of the bag [mm]
constexpr double opening = 2.6;
constexpr double front = 1.2;  ///< of the bag, from its equator
constexpr double back = 2.2;

/// A round sheet, its middle the posterior pole, drawn forward round the equator to the opening.
TriMesh bag_mesh() {
    TriMesh mesh = round_sheet(1.0, 1500);
    const double turn = std::numbers::pi - std::asin(opening / equator);
    for (Vec3& node : mesh.nodes) {
        const double share = node.head<2>().norm();
        const double angle = turn * share;
        const double radius = equator * std::sin(angle);
        const Vec2 way = share > 0.0 ? Vec2(node.head<2>() / share) : Vec2(Vec2::Zero());
        const double depth = -std::cos(angle);
        node = Vec3(radius * way.x(), radius * way.y(), depth * (depth < 0.0 ? back : front));
    }
    return mesh;
}

Pose turned(double degrees, const Vec3& axis, const Vec3& shift = Vec3::Zero()) {
    return {shift, Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis))};
}

/// An eye with an implant that lies flat in the middle of its bag, an injector outside, and a hook.
struct Bench {
    EyeModel eye = make_eye(Patient{}, false).value();
    WorldModel world;
    WorldState state;
    std::vector<ToolState> tools;
    ContactSet contacts;
    std::vector<double> memory;
    Observation observation;
    std::optional<Observer> observer;

    Bench() {
        const ImplantShape shape;
        world.shells.push_back(free_implant(shape));
        world.implant = implant_parts(shape);
        MembraneModel& bag = world.membranes.emplace_back();
        bag.name = empty_bag_name;
        bag.sheet = std::make_shared<const MembraneSheet>(uniform_sheet(bag_mesh(), Vec3(0.1, 0.2, 0.3), 0.01));
        world.tools.push_back(make_tool("injector").value());
        world.tools.push_back(make_tool("hook").value());
        state = rest_state(world);
        tools.resize(2);
        observer.emplace(world, ObservedTissues{false, false, true, true}, 0.01);
    }

    [[nodiscard]] ObserveInput input() const { return {eye, world, state, tools, contacts, 0.01}; }

    Bench& look() {
        observer->observe(input(), memory, observation);
        return *this;
    }

    double operator()(const std::string& name) const {
        for (std::size_t i = 0; i < observer->schema().size(); ++i) {
            if (observer->schema()[i].name == name) {
                return observation.values[i];
            }
        }
        FAIL("no measure " << name);
        return 0.0;
    }

    [[nodiscard]] Landmark mark(const std::string& name) const {
        for (const Landmark& mark : observer->percept(input(), observation).landmarks) {
            if (mark.name == name) {
                return mark;
            }
        }
        FAIL("no landmark " << name);
        return {};
    }

    [[nodiscard]] std::vector<Vec3>& lens() { return state.shells[0].position; }
    [[nodiscard]] std::vector<Vec3>& bag() { return state.membranes[0].position; }

    void move_lens(const Pose& by) { state.shells[0] = moved(state.shells[0], by); }
    void move_bag(const Pose& by) {
        for (Vec3& place : bag()) {
            place = by.to_world(place);
        }
    }

    void press(const Vec3& place, double force_mN) {
        Contact contact;
        contact.solid = -1;
        contact.membrane = 0;
        contact.partner_index = 1;
        contact.force = Vec3(0.0, 0.0, -1e3 * force_mN);
        const std::array<int, 3>& nodes =
            state.membranes[0].sheet->mesh.triangles[at(nearest_triangle(state.membranes[0].sheet->mesh, place))];
        contact.nodes = nodes;
        contact.weights = {0.2, 0.3, 0.5};
        contacts = {contact};
    }
};

}  // namespace

TEST_SUITE("implant measures") {
    TEST_CASE("a flat lens in the middle of its bag lies right") {
        Bench eye;
        eye.look();
        CHECK(eye("implant.released") == 1.0);
        CHECK(eye("implant.unfolded") == doctest::Approx(1.0));
        CHECK(eye("implant.upside_down") == 0.0);
        CHECK(eye("implant.tilt_deg") < 1e-6);
        CHECK(eye("implant.decentration_mm") < 1e-6);
        CHECK(eye("implant.haptics_on_optic") == 0.0);
        CHECK(eye("bag.rim_stretch") == doctest::Approx(1.0));
        CHECK(eye("bag.rim_peak_stretch") == doctest::Approx(1.0));
        CHECK(eye("bag.rim_split") == 0.0);
        CHECK(eye("bag.posterior_force_mN") == 0.0);
        CHECK(eye("bag.posterior_touches") == 0.0);
    }

    TEST_CASE("tilt, decentration and side are those that the lens is given") {
        Bench eye;
        eye.move_lens(turned(7.0, Vec3::UnitX()));
        eye.look();
        CHECK(eye("implant.tilt_deg") == doctest::Approx(7.0).epsilon(1e-6));
        CHECK(eye("implant.decentration_mm") < 1e-6);
        eye = Bench();
        eye.move_lens(turned(30.0, Vec3::UnitZ(), Vec3(0.24, -0.32, -0.1)));
        eye.look();
        CHECK(eye("implant.decentration_mm") == doctest::Approx(0.4).epsilon(1e-6));
        CHECK(eye("implant.tilt_deg") < 1e-6);
        eye = Bench();
        eye.move_lens(turned(173.0, Vec3::UnitY()));
        eye.look();
        CHECK(eye("implant.upside_down") == 1.0);
        CHECK(eye("implant.tilt_deg") == doctest::Approx(7.0).epsilon(1e-6));
    }

    TEST_CASE("they are measured against the bag as it lies now") {
        Bench eye;
        const Pose by = turned(9.0, Vec3(0.6, 0.8, 0.0), Vec3(0.3, 0.2, -0.4));
        eye.move_bag(by);
        eye.look();
        CHECK(eye("implant.tilt_deg") == doctest::Approx(9.0).epsilon(1e-6));
        CHECK(eye("implant.decentration_mm") > 0.3);
        eye.move_lens(by);
        eye.look();
        CHECK(eye("implant.tilt_deg") < 1e-6);
        CHECK(eye("implant.decentration_mm") < 1e-6);
        CHECK(eye("implant.haptics_in_bag") == eye("implant.haptic_leading_in_bag") * 2.0);
        CHECK((eye.mark("bag_equator").position - by.position).norm() < 0.1);  // the mesh has no node just there
    }

    TEST_CASE("a haptic is in the bag where its end is behind the opening and within the wall") {
        Bench eye;
        // as wide as it is at rest a lens does not go into the bag; its ends do where the bag has bent them in
        for (const int tip : eye.world.implant->tip) {
            eye.lens()[at(tip)] *= 4.5 / eye.lens()[at(tip)].norm();
        }
        const std::vector<Vec3> inside = eye.lens();
        eye.look();
        CHECK(eye("implant.haptics_in_bag") == 2.0);
        eye.lens()[at(eye.world.implant->tip[1])].z() = front + 0.3;
        eye.look();
        CHECK(eye("implant.haptic_leading_in_bag") == 1.0);
        CHECK(eye("implant.haptic_trailing_in_bag") == 0.0);
        CHECK(eye("implant.haptics_in_bag") == 1.0);
        eye.lens() = inside;
        eye.lens()[at(eye.world.implant->tip[0])] *= 1.3;
        eye.look();
        CHECK(eye("implant.haptic_leading_in_bag") == 0.0);
        CHECK(eye("implant.haptic_trailing_in_bag") == 1.0);
        eye.lens() = inside;
        eye.lens()[at(eye.world.implant->tip[0])].z() =
            0.8;  // in the sulcus: before the wall, behind the opening's plane
        eye.look();
        CHECK(eye("implant.haptic_leading_in_bag") == 0.0);
        const Pose by = turned(40.0, Vec3(0.0, 1.0, 0.0), Vec3(1.0, -2.0, 0.5));
        eye.lens() = inside;
        eye.move_lens(by);
        eye.move_bag(by);
        eye.look();
        CHECK(eye("implant.haptics_in_bag") == 2.0);
    }

    TEST_CASE("an arm that is folded onto the optic touches it") {
        Bench eye;
        for (Vec3& place : eye.lens()) {
            place = place.y() > 3.3 ? Vec3(place.x(), 6.6 - place.y(), 0.55) : place;
        }
        eye.look();
        CHECK(eye("implant.haptics_on_optic") == 1.0);
        for (Vec3& place : eye.lens()) {
            place.z() += place.z() > 0.5 ? 0.3 : 0.0;
        }
        eye.look();
        CHECK(eye("implant.haptics_on_optic") == 0.0);
    }

    TEST_CASE("a rolled optic casts little shadow, and where it is rolled up none") {
        Bench eye;
        const std::vector<Vec3> flat = eye.lens();
        const auto roll = [&](double radius) {
            for (std::size_t n = 0; n < flat.size(); ++n) {
                const double turn = flat[n].x() / radius;
                eye.lens()[n] =
                    Vec3(radius * std::sin(turn), flat[n].y(), radius * (1.0 - std::cos(turn)) + flat[n].z());
            }
            eye.look();
            return eye("implant.unfolded");
        };
        CHECK(roll(20.0) > 0.99);
        CHECK(roll(3.0) == doctest::Approx(0.88).epsilon(0.02));
        CHECK(roll(1.0) < 0.35);
        CHECK(eye("implant.upside_down") == 0.0);
    }

    TEST_CASE("what lies in the injector is not released, shows nowhere and touches no cornea") {
        Bench eye;
        const Cartridge& cartridge = *eye.world.tools[0].cartridge;
        eye.state.shells[0].loaded = true;
        eye.look();
        CHECK(eye("implant.released") == 0.0);
        CHECK(eye("implant.unfolded") == 0.0);
        CHECK(std::isnan(eye("implant.tilt_deg")));
        CHECK(std::isnan(eye("implant.decentration_mm")));
        CHECK(std::isnan(eye("implant.cornea_mm")));
        CHECK(eye("implant.haptics_in_bag") == 0.0);
        CHECK_FALSE(eye.mark("optic").visible);
        eye.state.shells[0].loaded = false;
        eye.tools[0].present = true;
        eye.tools[0].pose = turned(90.0, Vec3::UnitX(), Vec3(0.0, -2.0, 0.0));  // its hand at -y
        eye.look();
        CHECK(eye("implant.released") == 0.0);  // the lower haptic is in the bore
        eye.tools[0].pose.position.y() = -7.0;
        eye.look();
        CHECK(eye("implant.released") == 1.0);
        eye.tools[0].pose.position = Vec3(0.0, -2.0, -0.5 * cartridge.bore.stations.back().half_width - 2.0);
        eye.look();
        CHECK(eye("implant.released") == 1.0);  // it lies beside
    }

    TEST_CASE("the gap to the cornea is that of the nearest place of its surface") {
        Bench eye;
        for (Vec3& place : eye.lens()) {
            place *= 0.7;  // flat it is wider than the eye
        }
        eye.look();
        const double before = eye("implant.cornea_mm");
        const double apex = eye.eye.anatomy.cornea_apex_z - eye.eye.anatomy.cornea_thickness;
        CHECK(before > 0.0);
        CHECK(before < apex - 0.35 + 1e-9);
        eye.move_lens({Vec3(0.0, 0.0, 2.0), Quat::Identity()});
        eye.look();
        CHECK(eye("implant.cornea_mm") < before - 1.0);
    }

    TEST_CASE("an eighth of the rim that is stretched counts as it is, whatever the mesh, and the peak stays") {
        Bench eye;
        const std::vector<Vec3> rest = eye.bag();
        for (Vec3& place : eye.bag()) {
            place.head<2>() *= place.z() > 0.5 * front ? 1.25 : 1.0;
        }
        eye.look();
        CHECK(eye("bag.rim_stretch") == doctest::Approx(1.25).epsilon(1e-6));
        eye.bag() = rest;
        eye.look();
        CHECK(eye("bag.rim_stretch") == doctest::Approx(1.0));
        CHECK(eye("bag.rim_peak_stretch") == doctest::Approx(1.25).epsilon(1e-6));
        CHECK(eye.mark("bag_rim").size == doctest::Approx(opening).epsilon(1e-3));
    }

    TEST_CASE("a tear from the rim is seen, a hole elsewhere and a copy of the sheet are none") {
        Bench eye;
        const MembraneSheet whole = *eye.world.membranes[0].sheet;
        eye.state.membranes[0].sheet = std::make_shared<const MembraneSheet>(whole);
        eye.look();
        CHECK(eye("bag.rim_split") == 0.0);
        const std::vector<std::vector<int>> rim = boundary_loops(whole.mesh, whole.neighbours);
        REQUIRE(rim.size() == 1);
        MembraneState& state = eye.state.membranes[0];
        const int node = rim[0][5];
        const Vec3 place = whole.mesh.nodes[at(node)];
        const Vec3 outwards = Vec3(place.x(), place.y(), 0.0).normalized();
        const Result<MembraneEdit> edit = notch(eye.world.membranes[0], state, node, outwards);
        REQUIRE_MESSAGE(edit.ok(), edit.error().text());
        state = applied(state, edit.value());
        const double rest_stretch = eye.look()("bag.rim_stretch");
        CHECK(eye("bag.rim_split") == 1.0);
        CHECK(rest_stretch == doctest::Approx(1.0));
        eye.state.membranes[0] = rest_state(eye.world.membranes[0]);
        eye.look();
        CHECK(eye("bag.rim_split") == 0.0);
    }

    TEST_CASE("forces on the back of the bag and on its rim are told apart, and presses counted") {
        Bench eye;
        eye.press(Vec3(0.5, 0.0, -back), 3.0);
        eye.look();
        CHECK(eye("bag.posterior_force_mN") == doctest::Approx(3.0));
        CHECK(eye("bag.rim_force_mN") == 0.0);
        CHECK(eye("bag.posterior_touches") == 1.0);
        eye.press(Vec3(0.5, 0.0, -back), 0.8);  // has not let go
        eye.look();
        eye.press(Vec3(0.5, 0.0, -back), 2.0);
        eye.look();
        CHECK(eye("bag.posterior_touches") == 1.0);
        eye.contacts.clear();
        eye.look();
        CHECK(eye("bag.posterior_force_mN") == 0.0);
        eye.press(Vec3(0.5, 0.0, -back), 0.9);
        eye.look();
        CHECK(eye("bag.posterior_touches") == 1.0);
        eye.press(Vec3(0.5, 0.0, -back), 1.1);
        eye.look();
        CHECK(eye("bag.posterior_touches") == 2.0);
        eye.press(Vec3(opening, 0.0, front), 5.0);
        eye.look();
        CHECK(eye("bag.rim_force_mN") > 2.5 - 1e-9);
        CHECK(eye("bag.rim_force_mN") < 5.0 + 1e-9);
        CHECK(eye("bag.posterior_force_mN") == 0.0);
    }

    TEST_CASE("what lies behind the iris does not show") {
        Bench eye;
        eye.look();
        CHECK(eye.mark("optic").visible);
        CHECK(eye.mark("optic").size == doctest::Approx(3.0));
        CHECK(eye.mark("bag_rim").visible);
        CHECK_FALSE(eye.mark("bag_equator").visible);
        CHECK_FALSE(eye.mark("haptic_leading").visible);
        CHECK(eye.mark("haptic_leading").position.y() > 4.0);
        CHECK((eye.mark("haptic_leading").position + eye.mark("haptic_trailing").position).norm() < 1e-9);
        const Vec3 tip = eye.mark("haptic_trailing").position;
        const Vec3 middle = eye.mark("haptic_trailing_middle").position;
        const Vec3 elbow = eye.mark("haptic_trailing_elbow").position;
        CHECK(elbow.head<2>().norm() > 6.0);
        CHECK((middle - elbow).norm() == doctest::Approx((middle - tip).norm()).epsilon(0.2));
        CHECK((eye.mark("haptic_leading_elbow").position + elbow).norm() < 1e-9);
        eye.lens()[at(eye.world.implant->tip[1])] = Vec3(0.0, -4.5, eye.eye.anatomy.iris_z + 0.5);
        eye.look();
        CHECK(eye.mark("haptic_trailing").visible);
    }
}
