// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "physics/anatomy/bag_contents.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "physics/fluid/hydrodissection_flow.hpp"
#include "tools/ia_tip.hpp"
#include "tools/rhexis_tools.hpp"

using namespace rhexis;

namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// A bag with everything that can be in it, a saline cannula and an irrigation/aspiration tip.
struct Scene {
    WorldModel model;
    WorldState state;
    std::vector<ToolState> tools;
    std::vector<MouthProbe> probes;

    explicit Scene(double freed = 0.0) {
        BagModel bag;
        bag.cushion = 1.5e5;
        bag.opening_radius = 2.6;
        bag.adherent.assign(4, 1);
        model.bags.push_back(bag);
        model.chamber.emplace();
        model.capsule.emplace();
        model.hydrodissection.emplace();
        model.hydrodissection->start_cleaved = freed;
        for (const Vec2& place : {Vec2(3.0, 0.1), Vec2(0.1, 3.0), Vec2(-3.0, 0.1), Vec2(0.1, -3.0)}) {
            model.hydrodissection->cell_of_node.push_back(cell_at(model.hydrodissection->cells, place));
        }
        model.cortex.emplace();
        model.retained.emplace();
        model.retained->start_front = 180.0;
        model.retained->start_behind = 40.0;
        model.retained->start_angle = 20.0;
        model.tools = {saline_cannula(), ia_tip()};
        state = rest_state(model);
        tools.resize(2);
        for (const ToolModel& tool : model.tools) {
            probes.push_back(mouth_probe(tool));
        }
    }

    void inject_at(const Vec3& place, double press) {
        tools[0].present = true;
        tools[0].pose.position = place;
        tools[0].jaw = press;
    }

    /// Its mouth, which looks up, at a place.
    void hold_mouth(const Vec3& place) {
        tools[1].present = true;
        tools[1].aspiration = 1.0;
        tools[1].pose.orientation = Quat(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);  // its y axis is up
        tools[1].pose.position = place - tools[1].pose.orientation * probes[1].mouth.centre;
    }

    [[nodiscard]] double wave_volume() const {
        const HydrodissectionModel& own = *model.hydrodissection;
        return wave_share(*state.hydrodissection) * own.layer * std::numbers::pi * own.cells.radius * own.cells.radius;
    }
};

const Vec3 under_rim(3.1, 0.0, 1.2);

}  // namespace

TEST_CASE("cells of the bag: every middle lies in its own cell") {
    for (const BagCells& cells : {BagCells{24, 4, 4.6}, BagCells{16, 3, 4.6}, BagCells{1, 1, 2.0}}) {
        for (int cell = 0; cell < cell_count(cells); ++cell) {
            CHECK(cell_at(cells, cell_middle(cells, cell)) == cell);
        }
        const int beyond = cell_at(cells, Vec2(100.0, 0.0));
        CHECK(beyond >= 0);
        CHECK(beyond < cell_count(cells));
    }
}

TEST_CASE("hydrodissection: what is injected is trapped or in the wave when nothing can come out") {
    Scene scene;
    scene.model.hydrodissection->egress = 0.0;
    scene.inject_at(under_rim, 0.2);
    const double before = scene.state.chamber->eye_volume;
    for (int i = 0; i < 20; ++i) {
        hydrodissect(scene.model, scene.tools, 0.01, scene.state);
    }
    const HydrodissectionState& hydro = *scene.state.hydrodissection;
    CHECK(hydro.under_rim);
    CHECK(hydro.injected > 5.0);
    CHECK(hydro.trapped + scene.wave_volume() == doctest::Approx(hydro.injected).epsilon(1e-9));
    CHECK(scene.state.chamber->eye_volume - before == doctest::Approx(hydro.injected).epsilon(1e-9));
    CHECK(forward_shift(*scene.model.hydrodissection, hydro) == doctest::Approx(hydro.trapped / 60.0));
}

TEST_CASE("hydrodissection: pressure of trapped fluid and the strain by it have their closed forms") {
    const Scene scene;
    const HydrodissectionModel& own = *scene.model.hydrodissection;
    CHECK(trapped_pressure(own, 0.0) == 0.0);
    CHECK(trapped_pressure(own, 30.0) / pascal_per_mmhg == doctest::Approx(30.0));
    const BagShape& bag = scene.model.bags[0].shape;
    const double radius = bag.radius * bag.radius / bag.posterior;
    const CapsuleModel& capsule = *scene.model.capsule;
    CHECK(trapped_strain(scene.model, 1000.0) ==
          doctest::Approx(0.1 * 1000.0 * radius * (1.0 - capsule.poisson_ratio) / (2.0 * capsule.membrane_stiffness)));
}

TEST_CASE("hydrodissection: in the chamber, or deep in the cortex, there is no wave") {
    for (const Vec3& place : {Vec3(0.0, 0.0, 2.5), Vec3(1.5, 0.0, 1.2), Vec3(3.1, 0.0, 0.0)}) {
        Scene scene;
        scene.inject_at(place, 1.0);
        for (int i = 0; i < 50; ++i) {
            hydrodissect(scene.model, scene.tools, 0.01, scene.state);
        }
        CHECK_FALSE(scene.state.hydrodissection->under_rim);
        CHECK(scene.state.hydrodissection->injected > 50.0);
        CHECK(scene.state.hydrodissection->trapped == 0.0);
        CHECK(wave_share(*scene.state.hydrodissection) == 0.0);
    }
}

TEST_CASE("hydrodissection: where wounds are simulated as well, only what they let out comes out") {
    for (const bool wounds : {false, true}) {
        Scene scene;
        if (wounds) {
            scene.model.wounds.emplace();
            scene.state = rest_state(scene.model);
        }
        scene.inject_at(under_rim, 1.0);
        double out = 0.0;
        for (int i = 0; i < 100; ++i) {
            step_fluid(scene.model, scene.tools, scene.probes, 0.01, scene.state);
            out += 0.01 * scene.state.flows.leak;
        }
        CAPTURE(wounds);
        CHECK((out > 1.0) == !wounds);  // none has been cut
    }
}

TEST_CASE("hydrodissection: the wave frees the cortex that it reaches, the near side first") {
    Scene scene;
    scene.model.hydrodissection->egress = 0.0;
    scene.inject_at(under_rim, 0.1);
    std::size_t first_far = 0;
    std::size_t first_near = 0;
    for (std::size_t i = 1; i < 2000 && first_far == 0; ++i) {
        hydrodissect(scene.model, scene.tools, 0.01, scene.state);
        const std::vector<std::uint8_t>& adherent = scene.state.bags[0].adherent;
        first_near = first_near == 0 && adherent[0] == 0 ? i : first_near;
        first_far = first_far == 0 && adherent[2] == 0 ? i : first_far;
    }
    CHECK(first_near > 0);
    CHECK(first_far > first_near);
}

TEST_CASE("hydrodissection: a pressure that parts nothing makes no wave") {
    Scene scene;
    scene.state.hydrodissection->entered = true;
    scene.state.hydrodissection->trapped = 1.9;  // 1.0 mmHg
    hydrodissect(scene.model, scene.tools, 0.01, scene.state);
    CHECK(wave_share(*scene.state.hydrodissection) == 0.0);
}

TEST_CASE("hydrodissection: trapped fluid leaves when the way is open, however long the step") {
    for (const double dt : {0.0, 0.001, 0.01, 1.0, 1e6}) {
        Scene scene;
        scene.state.hydrodissection->trapped = 20.0;
        hydrodissect(scene.model, scene.tools, dt, scene.state);
        const double left = scene.state.hydrodissection->trapped;
        CHECK(left >= 0.0);
        CHECK(left <= 20.0);
        CHECK((dt < 1.0 || left < 5.0));
    }
}

TEST_CASE("hydrodissection: a lens that stands forward shuts the way, pressed back it opens it") {
    Scene scene;
    HydrodissectionState& hydro = *scene.state.hydrodissection;
    BagState& bag = scene.state.bags[0];
    const auto left_after = [&](double forward) {
        hydro.trapped = 36.0;
        const double still = diaphragm_shift(*scene.model.chamber, scene.state.chamber->eye_volume - 36.0, 0.0);
        bag.pose.position.z() = still + forward;
        bag.cushion_z = still + 0.6;
        for (int i = 0; i < 20; ++i) {
            hydrodissect(scene.model, scene.tools, 0.01, scene.state);
        }
        return hydro.trapped;
    };
    CHECK(left_after(0.6) > 35.0);
    CHECK(left_after(0.1) < 15.0);
}

TEST_CASE("hydrodissection: the capsule bursts above what it bears, and the fluid is lost") {
    Scene scene;
    HydrodissectionState& hydro = *scene.state.hydrodissection;
    hydro.entry = under_rim;
    hydro.pressure = 90.0 * pascal_per_mmhg;
    scene.model.capsule->ultimate_strain = 1.01 * trapped_strain(scene.model, hydro.pressure);
    strain_by_trapped(scene.model, 0.01, scene.state);
    CHECK(hydro.burst_s < 0.0);
    hydro.pressure *= 1.02;
    strain_by_trapped(scene.model, 0.01, scene.state);
    CHECK(hydro.burst_s == 0.0);
    CHECK(scene.state.capsule->hole_radius == doctest::Approx(1.0));
    CHECK(scene.state.capsule->hole_place.x() < 0.0);
    hydro.trapped = 60.0;
    for (int i = 0; i < 100; ++i) {
        hydrodissect(scene.model, scene.tools, 0.01, scene.state);
        strain_by_trapped(scene.model, 0.01, scene.state);
    }
    CHECK(hydro.trapped < 0.1);
    CHECK(pupil_share(*scene.model.hydrodissection, hydro) == doctest::Approx(0.75));
    const Vec6 load = contents_load(scene.model, scene.state, scene.state.bags[0].pose);
    CHECK(load.z() == doctest::Approx(-scene.model.hydrodissection->sink));
    hydro.lifted = 40.0;
    CHECK(contents_load(scene.model, scene.state, scene.state.bags[0].pose).isZero());
}

TEST_CASE("hydrodissection: a start with a part of the cortex free") {
    CHECK(wave_share(*Scene(0.0).state.hydrodissection) == 0.0);
    CHECK(wave_share(*Scene(1.0).state.hydrodissection) == 1.0);
    const double half = wave_share(*Scene(0.5).state.hydrodissection);
    CHECK(half == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("cortex: held, stripped by a pull above its adhesion, and taken; its volume is conserved") {
    Scene scene;
    CortexState& cortex = *scene.state.cortex;
    const double all = sum(cortex.volume);
    const Vec3 place = cortex_place(*scene.model.cortex, scene.model.bags[0].shape, 2);
    scene.hold_mouth(place - Vec3(0.0, 0.0, 0.2));
    const auto step = [&](double suction_mmhg, double flow) {
        scene.state.tips[1].open = 1.0;
        look_for_cortex(scene.model, scene.tools, scene.probes, scene.state);
        scene.state.tips[1].suction = suction_mmhg * pascal_per_mmhg;
        scene.state.tips[1].flow = flow;
        strip_cortex(scene.model, scene.tools, scene.probes, 0.01, scene.state);
    };
    step(20.0, 0.0);
    CHECK(cortex.tool == 1);
    CHECK_FALSE(cortex.held);
    CHECK(scene.state.tips[1].open < 0.1);
    step(300.0, 100.0);
    CHECK(cortex.held);
    CHECK(cortex.cell == 2);
    CHECK(cortex.taken == 0.0);
    scene.hold_mouth(0.5 * place);
    step(300.0, 100.0);
    CHECK(cortex.pull.norm() > scene.model.cortex->adhesion);
    CHECK(cortex.pull.norm() <= 300.0 * pascal_per_mmhg * scene.probes[1].area * (1.0 + 1e-12));
    const Vec6 load = contents_load(scene.model, scene.state, scene.state.bags[0].pose);
    CHECK(load.head<3>().dot(place) < 0.0);
    for (int i = 0; i < 300; ++i) {
        step(300.0, 100.0);
        CHECK(sum(cortex.volume) + cortex.taken == doctest::Approx(all).epsilon(1e-12));
    }
    CHECK(cortex.volume[0] == 0.0);
    CHECK(cortex.volume[1] == 0.0);
    CHECK(cortex.volume[2] == 0.0);
    CHECK(cortex_left(*scene.model.cortex, cortex) == doctest::Approx(45.0 / 48.0));
}

TEST_CASE("cortex: too little vacuum strips nothing") {
    Scene scene;
    const Vec3 place = cortex_place(*scene.model.cortex, scene.model.bags[0].shape, 2);
    scene.hold_mouth(place - Vec3(0.0, 0.0, 0.2));
    for (int i = 0; i < 200; ++i) {
        look_for_cortex(scene.model, scene.tools, scene.probes, scene.state);
        scene.state.tips[1].suction = 80.0 * pascal_per_mmhg;
        scene.state.tips[1].flow = 100.0;
        strip_cortex(scene.model, scene.tools, scene.probes, 0.01, scene.state);
        if (i == 5) {
            scene.hold_mouth(place - Vec3(1.0, 0.0, 0.2));
        }
    }
    CHECK(scene.state.cortex->taken == 0.0);
    CHECK(scene.state.cortex->attached[2] == 1.0);
}

TEST_CASE("viscoelastic: from behind the optic only where the mouth is, or by rocking; nothing is lost") {
    Scene scene;
    RetainedViscoelasticState& left = *scene.state.retained;
    const double all = viscoelastic_left(left);
    scene.state.tips[1].flow = 300.0;
    scene.hold_mouth(Vec3(0.0, 0.0, 1.5));
    for (int i = 0; i < 500; ++i) {
        remove_viscoelastic(scene.model, scene.tools, scene.probes, 0.01, scene.state);
    }
    CHECK(left.front < 5.0);
    CHECK(left.behind == doctest::Approx(40.0));
    scene.hold_mouth(Vec3(1.0, 0.0, -1.5));
    remove_viscoelastic(scene.model, scene.tools, scene.probes, 0.01, scene.state);
    CHECK(left.under == 1.0);
    CHECK(left.behind < 40.0);
    for (int i = 0; i < 500; ++i) {
        remove_viscoelastic(scene.model, scene.tools, scene.probes, 0.01, scene.state);
    }
    CHECK(left.behind < 1.0);
    CHECK(viscoelastic_left(left) + left.taken == doctest::Approx(all));
    remove_viscoelastic(scene.model, scene.tools, scene.probes, 1e9, scene.state);
    CHECK(left.behind >= 0.0);
    CHECK(viscoelastic_left(left) + left.taken == doctest::Approx(all));
}

TEST_CASE("viscoelastic: irrigation alone washes the front slowly") {
    Scene scene;
    scene.state.flows.infusion = 1000.0 / 3.0;
    for (int i = 0; i < 1000; ++i) {
        remove_viscoelastic(scene.model, scene.tools, scene.probes, 0.01, scene.state);
    }
    CHECK(scene.state.retained->front == doctest::Approx(180.0 * std::exp(-0.2)).epsilon(1e-3));
    CHECK(scene.state.retained->behind == 40.0);
}
