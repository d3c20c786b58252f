// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "eye/make_eye.hpp"
#include "mesh/shapes.hpp"
#include "observe/observer.hpp"
#include "scenes/membranes.hpp"
#include "topology/tear.hpp"

using namespace rhexis;

namespace {

/// A default eye with one instrument, and what an observer needs.
struct Bench {
    EyeModel eye;
    WorldModel world;
    WorldState state;
    std::vector<ToolState> tools;
    ContactSet contacts;
    std::vector<double> memory;
    Observation observation;

    explicit Bench(int tetrahedra = 1500) {
        Patient patient;
        patient.tetrahedra = tetrahedra;
        eye = make_eye(patient).value();
        world.solids.push_back(eye.lens);
        world.bags.push_back(eye.bag);
        ToolModel tool;
        tool.name = "phaco";
        tool.kind = ToolKind::phaco;
        tool.parts = {{Vec3(0, 0, 0.45), Vec3(0, 0, 20.0), 0.45, 0.45}};
        world.tools.push_back(tool);
        state = rest_state(world);
        tools.resize(1);
    }

    [[nodiscard]] ObserveInput input() const { return {eye, world, state, tools, contacts, 0.01}; }
    void observe(Observer& observer) { observer.observe(input(), memory, observation); }

    double value(const Observer& observer, const std::string& name) const {
        for (std::size_t i = 0; i < observer.schema().size(); ++i) {
            if (observer.schema()[i].name == name) {
                return observation.values[i];
            }
        }
        FAIL("no measure " << name);
        return 0.0;
    }

    void tip_at(const Vec3& place) {
        tools[0].previous_pose = tools[0].present ? tools[0].pose : Pose{place, Quat::Identity()};
        tools[0].present = true;
        tools[0].pose = {place, Quat::Identity()};
        tools[0].velocity = (place - tools[0].previous_pose.position) / 0.01;
    }

    /// Removes fine tetrahedra whose centre at rest meets the condition.
    void remove(const std::function<bool(const Vec3&)>& condition) {
        std::vector<Vec3> rest;
        fine_positions(world.solids[0].fine, world.solids[0].coarse.nodes, rest);
        for (std::size_t t = 0; t < world.solids[0].fine.tets.size(); ++t) {
            Vec3 centre = Vec3::Zero();
            for (const int node : world.solids[0].fine.tets[t]) {
                centre += 0.25 * rest[node];
            }
            if (condition(centre)) {
                state.solids[0].fraction[t] = 0.0;
            }
        }
    }
};

constexpr ObservedTissues all_tissues{true, true, true, true};

/// A trench of the given half width and half length (about the axis, along `angle` from +y), `depth` deep.
std::function<bool(const Vec3&)> trench(const ColumnGrid& grid, double half_width, double half_length, double depth,
                                        double angle) {
    return [&grid, half_width, half_length, depth, angle](const Vec3& p) {
        const double along = p.x() * std::sin(angle) + p.y() * std::cos(angle);
        const double across = p.x() * std::cos(angle) - p.y() * std::sin(angle);
        return std::abs(across) < half_width && std::abs(along) < half_length &&
               front_surface(grid, Vec2(p.x(), p.y())) - p.z() < depth;
    };
}

}  // namespace

TEST_SUITE("observe") {
    TEST_CASE("movements, rest, jerk and entries of the instruments") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        const auto go = [&](double seconds, double mm_s) {
            for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) {
                bench.tip_at(bench.tools[0].pose.position + Vec3(0.01 * mm_s, 0.0, 0.0));
                bench.observe(observer);
            }
        };
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.entries") == 0.0);
        CHECK(bench.value(observer, "instruments.idle") == 0.0);
        CHECK(std::isnan(bench.value(observer, "instruments.jerk_mm_s3")));
        bench.tip_at({0.0, 0.0, 2.5});
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.entries") == 1.0);
        CHECK(bench.value(observer, "instruments.idle") == 1.0);
        go(0.5, 4.0);
        CHECK(bench.value(observer, "instruments.movements") == 1.0);
        CHECK(bench.value(observer, "instruments.idle") == 0.0);
        CHECK(bench.value(observer, "instruments.path_mm") == doctest::Approx(2.0));
        const double begun = bench.value(observer, "instruments.jerk_mm_s3");
        CHECK(begun > 100.0);
        go(2.0, 0.0);
        CHECK(bench.value(observer, "instruments.idle") == 1.0);
        CHECK(bench.value(observer, "instruments.jerk_mm_s3") < begun);
        bench.tools[0].aspiration = 0.5;
        go(0.1, 0.0);
        CHECK(bench.value(observer, "instruments.idle") == 0.0);
        bench.tools[0].aspiration = 0.0;
        go(1.0, 4.0);
        CHECK(bench.value(observer, "instruments.movements") == 2.0);
        bench.tools[0].present = false;
        bench.observe(observer);
        bench.tip_at({0.0, 0.0, 2.5});
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.entries") == 2.0);
    }

    TEST_CASE("tremor is no movement, and a tip under the iris is hidden") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        for (int i = 0; i < 300; ++i) {
            bench.tip_at({0.1 * ((i / 5) % 2 == 0 ? 1.0 : -1.0), 0.0, 2.5});  // 10 Hz, 0.1 mm
            bench.observe(observer);
        }
        CHECK(bench.value(observer, "instruments.movements") <= 1.0);
        CHECK(bench.value(observer, "instruments.hidden") == 0.0);
        const EyeAnatomy& eye = bench.eye.anatomy;
        bench.tip_at({eye.pupil_radius + 0.3, 0.0, eye.iris_z + 0.3});
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.hidden") == 0.0);
        bench.tip_at({eye.pupil_radius + 0.3, 0.0, eye.iris_z - 0.3});
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.hidden") == 1.0);
        bench.tip_at({eye.pupil_radius - 0.3, 0.0, eye.iris_z - 0.3});
        bench.observe(observer);
        CHECK(bench.value(observer, "instruments.hidden") == 0.0);
    }

    TEST_CASE("columns hold the volume of the lens") {
        const Bench bench;
        const SolidModel& lens = bench.world.solids[0];
        const ColumnGrid grid = make_columns(lens, 0.1);
        double volume = 0.0;
        for (const ColumnSegment& segment : grid.segments) {
            volume += (segment.high - segment.low) * grid.cell * grid.cell;
        }
        CHECK(volume == doctest::Approx(mesh_volume(lens.coarse)).epsilon(0.01));
        const int axis = grid.cell_at(Vec2::Zero());
        CHECK(grid.front[axis] > 1.5);
        CHECK(grid.thickness(axis) == doctest::Approx(4.56).epsilon(0.05));
        CHECK(std::isnan(front_surface(grid, Vec2(6.0, 0.0))));
    }

    TEST_CASE("chords of a column fill it from back to front without gap") {
        const Bench bench;
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.3);
        for (int cell = 0; cell < grid.cells(); ++cell) {
            double length = 0.0;
            for (int i = grid.first[cell]; i < grid.first[cell + 1]; ++i) {
                length += grid.segments[i].high - grid.segments[i].low;
            }
            if (grid.inside(cell)) {
                CHECK(length == doctest::Approx(grid.thickness(cell)).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("an untouched lens has no groove, no shift and no loss") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        bench.observe(observer);
        CHECK(bench.value(observer, "groove.exists") == 0.0);
        CHECK(bench.value(observer, "groove.depth_mm") == 0.0);
        CHECK(std::isnan(bench.value(observer, "groove.floor_posterior_mm")));
        CHECK(bench.value(observer, "lens.displacement_mm") == 0.0);
        CHECK(bench.value(observer, "lens.rotation_deg") == 0.0);
        CHECK(bench.value(observer, "lens.removed_mm3") == 0.0);
        CHECK(bench.value(observer, "zonules.strain") == 0.0);
        CHECK(std::isnan(bench.value(observer, "phaco.tip_depth_mm")));
        CHECK(observer.schema().size() == bench.observation.values.size());
    }

    TEST_CASE("a world with an anterior capsule has the measures of a rhexis, another has not") {
        Bench bench;
        const auto has = [&] {
            const Observer observer(bench.world, all_tissues, 0.01);
            return std::any_of(observer.schema().begin(), observer.schema().end(),
                               [](const MeasureInfo& measure) { return measure.name.starts_with("rhexis."); });
        };
        CHECK_FALSE(has());
        bench.world.membranes.push_back(scenes::membrane("iris", square_sheet(1.0, 8), {1.0e6, 1.0e6, 0.45, 0.0}));
        CHECK_FALSE(has());
        const TriMesh sheet = round_sheet(5.0, 600);
        bench.world.membranes.push_back(scenes::membrane("anterior_capsule", sheet, {1.0e6, 1.0e6, 0.45, 0.0}));
        bench.state = rest_state(bench.world);
        Observer observer(bench.world, all_tissues, 0.01);
        bench.observe(observer);
        CHECK(bench.value(observer, "rhexis.opened") == 0.0);
        CHECK(std::isnan(bench.value(observer, "rhexis.tip_radius_mm")));
        CHECK(std::isnan(bench.value(observer, "rhexis.centre_offset_mm")));
        const Vec3 place(2.0, 0.0, 0.0);
        MembraneState& capsule = bench.state.membranes[1];
        const Result<MembraneEdit> slit =
            puncture(bench.world.membranes[1], capsule, nearest_triangle(sheet, place), place, Vec3::UnitY());
        REQUIRE(slit.ok());
        capsule = applied(capsule, slit.value());
        bench.observe(observer);
        CHECK(bench.value(observer, "rhexis.opened") == 1.0);
        CHECK(bench.value(observer, "rhexis.closed") == 0.0);
        CHECK(bench.value(observer, "rhexis.torn_mm") > 0.5);
        CHECK(bench.value(observer, "rhexis.turned_deg") > 10.0);
        CHECK(bench.value(observer, "rhexis.tip_radius_mm") == doctest::Approx(2.0).epsilon(0.2));
        CHECK(std::isnan(bench.value(observer, "rhexis.diameter_mm")));
    }

    TEST_CASE("a trench is measured as long, wide, deep and turned as it was cut") {
        for (const double angle : {0.0, 0.5, -0.9}) {
            Bench bench(3000);
            const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
            bench.remove(trench(grid, 0.6, 2.0, 2.0, angle));
            Observer observer(bench.world, all_tissues, 0.01);
            bench.observe(observer);
            CHECK(bench.value(observer, "groove.exists") == 1.0);
            CHECK(bench.value(observer, "groove.depth_mm") == doctest::Approx(2.0).epsilon(0.12));
            CHECK(bench.value(observer, "groove.mean_depth_mm") == doctest::Approx(1.9).epsilon(0.15));
            CHECK(bench.value(observer, "groove.length_mm") == doctest::Approx(4.0).epsilon(0.15));
            CHECK(bench.value(observer, "groove.width_mm") == doctest::Approx(1.2).epsilon(0.3));
            CHECK(std::abs(bench.value(observer, "groove.direction_deg") - angle * 180.0 / 3.14159265) < 3.0);
            const double share = bench.value(observer, "groove.depth_share");
            CHECK(share == doctest::Approx(2.0 / 4.5).epsilon(0.15));
            const double floor = bench.value(observer, "groove.floor_posterior_mm");
            CHECK(floor > 1.8);
            CHECK(floor < 3.2);
        }
    }

    TEST_CASE("depth grows with the trench and one stray tetrahedron is no groove") {
        Bench bench(3000);
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
        Observer observer(bench.world, all_tissues, 0.01);
        double last_depth = 0.0;
        double last_light = 0.0;
        for (const double depth : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}) {
            bench.remove(trench(grid, 0.6, 2.0, depth, 0.0));
            bench.tip_at(Vec3(0.0, 0.0, grid.front[grid.cell_at(Vec2::Zero())] - depth));
            bench.observe(observer);
            CHECK(bench.value(observer, "groove.depth_mm") > last_depth);
            CHECK(bench.value(observer, "reflex.tip") > last_light);
            CHECK(bench.value(observer, "reflex.tip") < 1.0);
            last_depth = bench.value(observer, "groove.depth_mm");
            last_light = bench.value(observer, "reflex.tip");
        }
        Bench stray(3000);
        stray.state.solids[0].fraction[1234] = 0.0;
        Observer other(stray.world, all_tissues, 0.01);
        stray.observe(other);
        CHECK(stray.value(other, "groove.depth_mm") < 0.3);
    }

    TEST_CASE("a shift and a turn of the lens are found") {
        Bench bench;
        const double angle = 0.1;
        const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
        for (Vec3& x : bench.state.solids[0].position) {
            x = turn * x + Vec3(0.3, 0.0, -0.4);
        }
        Observer observer(bench.world, all_tissues, 0.01);
        bench.observe(observer);
        CHECK(bench.value(observer, "lens.displacement_mm") == doctest::Approx(0.5).epsilon(1e-3));
        CHECK(bench.value(observer, "lens.rotation_deg") == doctest::Approx(angle * 180.0 / 3.14159265).epsilon(1e-6));
    }

    TEST_CASE("turns of the lens add up past half a turn, and what the bag did not follow is slip") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        const std::vector<Vec3> rest = bench.state.solids[0].position;
        bench.state.bags[0].pose.orientation = Quat(Eigen::AngleAxisd(0.05, Vec3::UnitZ()));
        for (int degrees = 0; degrees >= -400; degrees -= 20) {
            const Mat3 turn = Eigen::AngleAxisd(degrees * 3.14159265358979 / 180.0, Vec3::UnitZ()).toRotationMatrix();
            for (std::size_t i = 0; i < rest.size(); ++i) {
                bench.state.solids[0].position[i] = turn * rest[i];
            }
            bench.observe(observer);
            CHECK(bench.value(observer, "lens.rotation_deg") == doctest::Approx(degrees).epsilon(1e-6));
        }
        const double bag_turn = 0.05 * 180.0 / 3.14159265358979;
        CHECK(bench.value(observer, "bag.turn_deg") == doctest::Approx(bag_turn));
        CHECK(bench.value(observer, "bag.slip_deg") == doctest::Approx(-400.0 - bag_turn));
        CHECK(bench.value(observer, "zonules.torque_mNmm") < 0.0);  // they turn the bag back
    }

    TEST_CASE("torque on the lens is arm times force about the bag's axis, tools and bag apart") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        bench.state.bags[0].pose.position = Vec3(0.5, 0.0, 0.0);
        Contact push;
        push.point = Vec3(0.5, 2.0, 1.0);
        push.force = Vec3(300.0, 0.0, -500.0);
        Contact drag = push;
        drag.partner = ContactPartner::bag;
        drag.point = Vec3(3.5, 0.0, 0.0);
        drag.force = Vec3(10.0, 100.0, 0.0);
        bench.contacts = {push, drag};
        bench.observe(observer);
        CHECK(bench.value(observer, "lens.tool_torque_mNmm") == doctest::Approx(-0.6));
        CHECK(bench.value(observer, "lens.bag_torque_mNmm") == doctest::Approx(0.3));
    }

    TEST_CASE("a cross cut into the lens is measured as two grooves, and their ends turn with it in the picture") {
        Bench bench(3000);
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
        bench.remove(trench(grid, 0.7, 2.5, 3.0, 0.0));
        bench.remove(trench(grid, 0.7, 2.5, 2.0, 1.5708));
        Observer observer(bench.world, all_tissues, 0.01);
        bench.observe(observer);
        CHECK(bench.value(observer, "grooves.count") == 2.0);
        CHECK(bench.value(observer, "grooves.angle_deg") > 85.0);
        CHECK(bench.value(observer, "groove_1.depth_mm") == doctest::Approx(3.0).epsilon(0.12));
        CHECK(bench.value(observer, "groove_2.depth_mm") == doctest::Approx(2.0).epsilon(0.12));
        for (const char* length : {"groove_1.length_mm", "groove_2.length_mm"}) {
            CHECK(bench.value(observer, length) == doctest::Approx(5.0).epsilon(0.12));
        }
        const auto end_of_first = [&] {
            for (const Landmark& mark : observer.percept(bench.input(), Observation{}).landmarks) {
                if (mark.name == "groove_1_end") {
                    return mark;
                }
            }
            return Landmark{};
        };
        const Vec3 before = end_of_first().position;
        CHECK(before.y() > 2.0);
        const Mat3 turn = Eigen::AngleAxisd(-1.5708, Vec3::UnitZ()).toRotationMatrix();
        for (Vec3& x : bench.state.solids[0].position) {
            x = turn * x;
        }
        bench.observe(observer);
        CHECK((end_of_first().position - turn * before).norm() < 0.2);
        CHECK(bench.value(observer, "grooves.count") == 2.0);
    }

    TEST_CASE("the tip's depth and distances are those of the geometry") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
        const double front = grid.front[grid.cell_at(Vec2::Zero())];
        bench.tip_at(Vec3(0.0, 0.0, front - 1.0));
        bench.observe(observer);
        CHECK(bench.value(observer, "phaco.tip_depth_mm") == doctest::Approx(1.0).epsilon(1e-9));
        CHECK(bench.value(observer, "phaco.inside_lens") == 1.0);
        const EyeAnatomy& eye = bench.eye.anatomy;
        const double back_of_cornea = eye.cornea_apex_z - eye.cornea_thickness;
        CHECK(bench.value(observer, "phaco.endothelium_mm") ==
              doctest::Approx(back_of_cornea - front + 1.0).epsilon(1e-9));
        bench.tip_at(Vec3(0.0, 0.0, -bench.eye.bag.shape.posterior + 0.25));
        bench.observe(observer);
        CHECK(bench.value(observer, "phaco.tip_posterior_mm") == doctest::Approx(0.25).epsilon(1e-6));
        CHECK(bench.value(observer, "phaco.capsule_gap_mm") == doctest::Approx(0.25).epsilon(0.05));
        CHECK(bench.value(observer, "phaco.capsule_touch") == 0.0);
        bench.tip_at(Vec3(0.0, 0.0, -bench.eye.bag.shape.posterior - 0.01));
        bench.observe(observer);
        CHECK(bench.value(observer, "phaco.capsule_touch") == 1.0);
        CHECK(bench.value(observer, "phaco.path_mm") ==
              doctest::Approx(front - 1.0 + bench.eye.bag.shape.posterior + 0.01).epsilon(1e-6));
    }

    TEST_CASE("the contact force is the sum over the instrument's contacts") {
        Bench bench;
        bench.tip_at(Vec3(0.0, 0.0, 2.0));
        Contact contact;
        contact.force = Vec3(3000.0, 0.0, 0.0);
        bench.contacts = {contact, contact};
        contact.partner = ContactPartner::bag;
        bench.contacts.push_back(contact);
        Observer observer(bench.world, all_tissues, 0.01);
        bench.observe(observer);
        CHECK(bench.value(observer, "phaco.force_mN") == doctest::Approx(6.0));
        CHECK(bench.value(observer, "phaco.in_contact") == 1.0);
    }

    TEST_CASE("ultrasound in the open is counted as idle") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        bench.tip_at(Vec3(0.0, 0.0, 4.0));
        bench.tools[0].power = 0.5;
        for (int i = 0; i < 10; ++i) {
            bench.contacts = i < 4 ? ContactSet{Contact{}} : ContactSet{};
            bench.observe(observer);
        }
        CHECK(bench.value(observer, "phaco.ultrasound_s") == doctest::Approx(0.1));
        CHECK(bench.value(observer, "phaco.idle_ultrasound_s") == doctest::Approx(0.06));
    }

    TEST_CASE("a trembling touch of the iris is one touch, and a clear pause makes two") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        const EyeAnatomy& eye = bench.eye.anatomy;
        const double above = eye.iris_z + 0.5 * eye.iris_thickness;
        const double r = 0.5 * (eye.pupil_radius + eye.limbus_radius);
        const auto hover = [&](double gap) {
            bench.tip_at(Vec3(r, 0.0, above + gap));
            bench.observe(observer);
        };
        hover(0.2);
        CHECK(bench.value(observer, "iris.gap_mm") == doctest::Approx(0.2).epsilon(1e-6));
        CHECK(bench.value(observer, "iris.touch") == 0.0);
        for (const double gap : {-0.01, 0.02, -0.01, 0.01, -0.02}) {
            hover(gap);
        }
        CHECK(bench.value(observer, "iris.touches") == 1.0);
        hover(0.2);
        hover(-0.01);
        CHECK(bench.value(observer, "iris.touches") == 2.0);
        bench.tools[0].present = false;
        bench.observe(observer);
        CHECK(std::isnan(bench.value(observer, "iris.gap_mm")));
    }

    TEST_CASE("tremor of 9 Hz is measured, slow movement is not") {
        Bench bench;
        Observer observer(bench.world, all_tissues, 0.01);
        for (int i = 0; i < 1000; ++i) {
            bench.tip_at(Vec3(0.1 * std::sin(2.0 * 3.14159265 * 9.0 * 0.01 * i), 0.0, 4.0));
            bench.observe(observer);
        }
        CHECK(bench.value(observer, "phaco.tremor_um") == doctest::Approx(1000.0 * 0.1 / std::sqrt(2.0)).epsilon(0.1));
        Bench slow;
        for (int i = 0; i < 1000; ++i) {
            slow.tip_at(Vec3(std::sin(2.0 * 3.14159265 * 0.5 * 0.01 * i), 0.0, 4.0));
            slow.observe(observer);
        }
        CHECK(slow.value(observer, "phaco.tremor_um") < 60.0);
    }

    TEST_CASE("an observation depends on state and memory alone, not on what was observed before") {
        Bench bench;
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
        Observer observer(bench.world, all_tissues, 0.01);
        bench.tip_at(Vec3(0.2, 0.0, 1.0));
        for (const double depth : {0.5, 1.0, 1.5}) {
            bench.remove(trench(grid, 0.6, 2.0, depth, 0.2));
            bench.observe(observer);
        }
        std::vector<double> memory = bench.memory;
        Observer fresh(bench.world, all_tissues, 0.01);
        Observation seen;
        fresh.observe(bench.input(), memory, seen);
        bench.observe(observer);
        REQUIRE(seen.values.size() == bench.observation.values.size());
        for (std::size_t i = 0; i < seen.values.size(); ++i) {
            CAPTURE(observer.schema()[i].name);
            CHECK((seen.values[i] == bench.observation.values[i] ||
                   (std::isnan(seen.values[i]) && std::isnan(bench.observation.values[i]))));
        }
        CHECK(memory == bench.memory);
    }

    TEST_CASE("the percept holds what can be seen: pupil, groove ends nearer and farther, brightness, panel") {
        Bench bench(3000);
        const ColumnGrid grid = make_columns(bench.world.solids[0], 0.2);
        Observer observer(bench.world, all_tissues, 0.01);
        bench.tip_at(Vec3(0.0, 0.0, 1.0));
        bench.tools[0].pedal = 2.5;
        bench.tools[0].power = 0.25;
        bench.observe(observer);
        const Percept before = observer.percept(bench.input(), Observation{});
        bench.remove(trench(grid, 0.6, 2.0, 2.0, 0.0));
        bench.observe(observer);
        const Percept percept = observer.percept(bench.input(), Observation{});
        const auto landmark = [&](const std::string& name) {
            for (const Landmark& mark : percept.landmarks) {
                if (mark.name == name) {
                    return mark;
                }
            }
            FAIL("no landmark " << name);
            return Landmark{};
        };
        CHECK(landmark("pupil").size == doctest::Approx(3.75));
        CHECK(landmark("groove_near").visible);
        CHECK(landmark("groove_near").position.y() < -1.5);
        CHECK(landmark("groove_far").position.y() > 1.5);
        CHECK(landmark("groove_floor").position.z() < landmark("lens_front").position.z() - 1.5);
        CHECK(landmark("surface_at_tip").position.z() < landmark("lens_front").position.z() - 1.5);
        CHECK(percept.tip_brightness > before.tip_brightness);
        CHECK(percept.pedal == 2.5);
        CHECK(percept.power == 0.25);
        for (const Landmark& mark : before.landmarks) {
            CHECK((mark.name.find("groove") != 0 || !mark.visible));
        }
    }
}
