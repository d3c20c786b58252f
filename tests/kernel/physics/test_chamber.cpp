// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "base/rng.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "scenes/surge.hpp"

using namespace rhexis;

namespace {

constexpr double mmhg = pascal_per_mmhg;
constexpr double ml_min = mm3_s_per_ml_min;

/// Quadrant removal: bottle at 90 cm, 30 ml/min, 400 mmHg.
ChamberControl aspirating(double tip_open) { return scenes::aspirating({}, tip_open); }

void run(const ChamberModel& model, const ChamberControl& control, double seconds, ChamberState& state) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.01)); ++i) {
        advance_chamber(model, control, 0.01, state);
    }
}

/// An eye that does not stiffen: with it and while nothing limits, the two tanks are linear.
ChamberModel linear_eye() {
    ChamberModel model;
    model.eye_stiffening = 0.0;
    return model;
}

/// The two tanks while nothing limits: x = (P_eye, P_tube, 1), d x / dt = rate * x, written down from the equations
/// and solved by the matrix exponential.
Eigen::Matrix3d linear_tanks(const ChamberModel& model, const ChamberControl& control) {
    const double in = control.irrigation ? 1.0 / model.infusion_resistance : 0.0;
    const double tip =
        control.tip_open > 0.0 ? 1.0 / (model.tube_resistance + model.tip_resistance / control.tip_open) : 0.0;
    const double bottle = 1e-3 * 9810.0 * control.bottle_height;
    Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();
    rate.row(0) = Eigen::RowVector3d(-(in + tip + model.leak_conductance), tip, in * bottle) / model.eye_compliance;
    rate.row(1) = Eigen::RowVector3d(tip, -tip, -control.pump_flow) / model.tube_compliance;
    return rate;
}

struct Track {
    double lowest = std::numeric_limits<double>::infinity();        ///< of the eye at the ends of steps [Pa]
    double lowest_exact = std::numeric_limits<double>::infinity();  ///< the same of the exact solution
    double lowest_within = std::numeric_limits<double>::infinity();
    double worst_eye = 0.0;  ///< farthest from exact, share of what the exact solution passes through
    double worst_tube = 0.0;
};

/// Steps of dt against the matrix exponential from the same start; `opening` says how open the tip is at each step.
template <typename Opening>
Track against_exponential(const ChamberModel& model, ChamberControl control, double seconds, double dt,
                          const Opening& opening, ChamberState& state) {
    Eigen::Vector3d exact(eye_pressure(model, state.eye_volume), tube_pressure(model, state.tube_volume), 1.0);
    Eigen::Vector3d low = exact;
    Eigen::Vector3d high = exact;
    Track track;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) {
        control.tip_open = opening(i * dt);
        const ChamberFlows flows = advance_chamber(model, control, dt, state);
        const Eigen::Matrix3d rate = dt * linear_tanks(model, control);
        const Eigen::Matrix3d propagator = rate.exp();
        exact = Eigen::Vector3d(propagator * exact);
        low = low.cwiseMin(exact);
        high = high.cwiseMax(exact);
        const double eye = eye_pressure(model, state.eye_volume);
        track.worst_eye = std::max(track.worst_eye, std::abs(eye - exact[0]));
        track.worst_tube = std::max(track.worst_tube, std::abs(tube_pressure(model, state.tube_volume) - exact[1]));
        track.lowest = std::min(track.lowest, eye);
        track.lowest_exact = std::min(track.lowest_exact, exact[0]);
        track.lowest_within = std::min(track.lowest_within, flows.lowest_eye_pressure);
    }
    track.worst_eye /= high[0] - low[0];
    track.worst_tube /= high[1] - low[1];
    return track;
}

double stored(const ChamberState& state) { return state.eye_volume + state.tube_volume; }

double supplied(const ChamberTotals& moved) { return moved.infused + moved.vented - moved.aspirated - moved.leaked; }

/// Pedal, occlusion and settings as a careless operator would change them, held for 0.01 to 0.5 s each.
ChamberControl random_control(Rng& rng) {
    ChamberControl control;
    const double pedal = 3.0 * rng.uniform();
    control.irrigation = pedal >= 1.0;
    control.vent = pedal < 2.0;
    control.pump_flow = pedal >= 2.0 ? 60.0 * ml_min * rng.uniform() : 0.0;
    control.vacuum_limit = 700.0 * mmhg * rng.uniform();
    control.bottle_height = 1500.0 * rng.uniform();
    const double opening = 2.0 * rng.uniform() - 0.5;
    control.tip_open = std::clamp(opening, 0.0, 1.0);
    return control;
}

std::string refused(const Status& status) { return status.ok() ? "accepted" : status.error().text(); }

}  // namespace

TEST_CASE("steady flow: the pump takes its flow, the bottle gives it and the leak's") {
    const ChamberModel model;
    const ChamberControl control = aspirating(1.0);
    ChamberState state = chamber_state(model, 0.0, 0.0);
    run(model, control, 10.0, state);
    const ChamberFlows flows = advance_chamber(model, control, 0.01, state);
    // By hand: (P_bottle - P_eye) / R_in = Q + leak P_eye.
    const double bottle = 1e-3 * 9810.0 * 900.0;
    const double eye = (bottle / model.infusion_resistance - control.pump_flow) /
                       (1.0 / model.infusion_resistance + model.leak_conductance);
    const double tube = eye - control.pump_flow * (model.tube_resistance + model.tip_resistance);
    CHECK(eye_pressure(model, state.eye_volume) == doctest::Approx(eye).epsilon(1e-9));
    CHECK(tube_pressure(model, state.tube_volume) == doctest::Approx(tube).epsilon(1e-9));
    CHECK(flows.pump == doctest::Approx(500.0).epsilon(1e-9));
    CHECK(flows.tip == doctest::Approx(500.0).epsilon(1e-9));
    CHECK(flows.infusion == doctest::Approx(500.0 + model.leak_conductance * eye).epsilon(1e-9));
    MESSAGE("steady: eye ", eye / mmhg, " mmHg, tubing ", tube / mmhg, " mmHg");
}

TEST_CASE("an occluding tip: eye and vacuum rise within 1 % of the matrix exponential of the two tanks") {
    const ChamberModel model = linear_eye();
    ChamberControl control = aspirating(1.0);
    control.vacuum_limit = 700.0 * mmhg;  // not reached here
    for (const double dt : {0.001, 0.01, 0.02}) {
        CAPTURE(dt);
        ChamberState state = chamber_state(model, 0.0, 0.0);
        run(model, control, 10.0, state);
        const double open_eye = eye_pressure(model, state.eye_volume);
        // Closes over 0.1 s, as the piece is drawn in, then holds for as long.
        const auto closing = [](double t) { return std::max(0.0, 1.0 - t / 0.1); };
        const Track track = against_exponential(model, control, 0.2, dt, closing, state);
        CHECK(track.worst_eye < 1e-3);
        CHECK(track.worst_tube < 1e-3);
        CHECK(eye_pressure(model, state.eye_volume) > open_eye + 10.0 * mmhg);
        CHECK(tube_pressure(model, state.tube_volume) < -350.0 * mmhg);
        MESSAGE("step ", dt, ": eye ", track.worst_eye, ", tubing ", track.worst_tube, " of their ranges");
    }
}

TEST_CASE("an occlusion breaks: the dip is within 1 % of the matrix exponential of the two tanks") {
    const ChamberModel model = linear_eye();
    ChamberControl control = aspirating(1.0);
    control.vacuum_limit = 700.0 * mmhg;
    for (const double vacuum : {400.0, 500.0, 600.0}) {
        for (const double dt : {0.001, 0.01, 0.02}) {
            CAPTURE(vacuum);
            CAPTURE(dt);
            const double held =
                bottle_pressure(model, 900.0) / (1.0 + model.infusion_resistance * model.leak_conductance);
            ChamberState state = chamber_state(model, held, -vacuum * mmhg);
            const Track track = against_exponential(
                model, control, 1.0, dt, [](double) { return 1.0; }, state);
            CHECK(track.worst_eye < 2e-3);
            CHECK(track.worst_tube < 2e-3);
            CHECK(std::abs(track.lowest - track.lowest_exact) < 2e-3 * (held - track.lowest_exact));
            CHECK(track.lowest_within <= track.lowest);
            CHECK(track.lowest < eye_pressure(model, state.eye_volume) - 2.0 * mmhg);  // it dips, then recovers
            MESSAGE("vacuum ", vacuum, " step ", dt, ": lowest ", track.lowest / mmhg, " mmHg, exact ",
                    track.lowest_exact / mmhg, "; eye ", track.worst_eye, ", tubing ", track.worst_tube);
        }
    }
}

TEST_CASE("the dip grows with vacuum and falls with bottle height") {
    for (const double tubing : {0.15, 0.3}) {  // the default and an older, softer one [mm^3/mmHg]
        ChamberModel model;
        model.tube_compliance = tubing / mmhg;
        for (const double bottle : {60.0, 90.0, 110.0}) {
            scenes::Surge before;
            before.lowest = std::numeric_limits<double>::infinity();
            for (const double vacuum : {200.0, 300.0, 400.0, 500.0, 600.0}) {
                CAPTURE(bottle);
                CAPTURE(vacuum);
                const scenes::Surge dip = scenes::surge(model, {bottle, 30.0, vacuum});
                CHECK(dip.lowest < before.lowest);
                CHECK(dip.lost > before.lost);
                before = dip;
                const scenes::Surge higher = scenes::surge(model, {bottle + 10.0, 30.0, vacuum});
                CHECK(higher.lowest > dip.lowest);
                CHECK(higher.lost < dip.lost);
                CHECK(higher.lowest / higher.held > dip.lowest / dip.held);
                MESSAGE("tubing ", tubing, ", bottle ", bottle, " cm, vacuum ", vacuum, " mmHg: ", dip.held / mmhg,
                        " to ", dip.lowest / mmhg, " mmHg, ", dip.lost, " mm^3");
            }
            CHECK(before.lowest < 0.5 * before.held);  // not just the drop to the steady pressure
        }
    }
}

TEST_CASE("what a higher bottle saves in volume comes from the stiffening of the eye") {
    const scenes::Surge low = scenes::surge(linear_eye(), {90.0, 30.0, 400.0});
    const scenes::Surge high = scenes::surge(linear_eye(), {110.0, 30.0, 400.0});
    CHECK(high.lowest > low.lowest);
    CHECK(high.lost > low.lost);
    CHECK(scenes::surge({}, {110.0, 30.0, 400.0}).lost < scenes::surge({}, {90.0, 30.0, 400.0}).lost);
}

TEST_CASE("the eye stiffens with pressure as Friedenwald says, and gives way below the collapse pressure") {
    const ChamberModel model;
    // ln(P2 / P1) = K (V2 - V1), K = 1 / (1.6 mm^3/mmHg * 50 mmHg).
    for (const double low : {5.0, 12.0, 40.0}) {
        const double volume = eye_volume(model, 80.0 * mmhg) - eye_volume(model, low * mmhg);
        CHECK(volume == doctest::Approx(80.0 * std::log(80.0 / low)).epsilon(1e-12));
    }
    for (double pressure = -50.0; pressure < 200.0; pressure += 1.7) {
        for (const double stiffening : {0.0, 1e-9, 0.3, 1.0}) {
            ChamberModel other = model;
            other.eye_stiffening = stiffening;
            const double volume = eye_volume(other, pressure * mmhg);
            CHECK(eye_pressure(other, volume) == doctest::Approx(pressure * mmhg).epsilon(1e-12));
            const double slope = (eye_pressure(other, volume + 1e-4) - eye_pressure(other, volume - 1e-4)) / 2e-4;
            CHECK(eye_stiffness(other, volume) == doctest::Approx(slope).epsilon(1e-6));
        }
    }
    CHECK(eye_stiffness(model, -1.0) * 16.0 == doctest::Approx(mmhg));
}

TEST_CASE("an eye that loses more than its wall can give collapses, and fills again") {
    ChamberModel model;
    model.tube_compliance *= 6.0;
    const double dip = scenes::surge(model, {60.0, 30.0, 600.0}).lowest;
    CHECK(dip < model.collapse_pressure);
    CHECK(dip > -10.0 * mmhg);  // soft: a linear tank would be sucked far below
    model.eye_stiffening = 0.0;
    CHECK(scenes::surge(model, {60.0, 30.0, 600.0}).lowest < -20.0 * mmhg);
    model = {};
    ChamberState state = chamber_state(model, -5.0 * mmhg, 0.0);
    ChamberControl control;
    control.irrigation = true;
    control.bottle_height = 600.0;
    control.tip_open = 0.0;
    run(model, control, 5.0, state);
    const double full = bottle_pressure(model, 600.0) / (1.0 + model.infusion_resistance * model.leak_conductance);
    CHECK(eye_pressure(model, state.eye_volume) == doctest::Approx(full).epsilon(1e-6));
}

TEST_CASE("occluded, the pump stands still at its vacuum limit; the tubing stores what it gave; the vent ends it") {
    const ChamberModel model;
    ChamberControl control = aspirating(0.0);
    ChamberState state = chamber_state(model, 0.0, 0.0);
    run(model, control, 10.0, state);
    CHECK(tube_pressure(model, state.tube_volume) == doctest::Approx(-400.0 * mmhg).epsilon(1e-6));
    CHECK(advance_chamber(model, control, 0.01, state).pump < 1e-6 * control.pump_flow);
    CHECK(state.totals.aspirated == doctest::Approx(0.15 * 400.0).epsilon(1e-6));

    control.vacuum_limit = 300.0 * mmhg;  // lowered below what is there: the pump does not push back
    CHECK(advance_chamber(model, control, 0.01, state).pump == 0.0);
    CHECK(tube_pressure(model, state.tube_volume) == doctest::Approx(-400.0 * mmhg).epsilon(1e-6));

    control.pump_flow = 0.0;  // pedal to 1
    control.vent = true;
    run(model, control, 1.0, state);
    CHECK(std::abs(tube_pressure(model, state.tube_volume)) < 0.1 * mmhg);
    CHECK(state.totals.vented == doctest::Approx(0.15 * 400.0).epsilon(1e-3));
    // The valve only relieves: with the tip open again the eye fills the tubing and nothing flows on.
    control.tip_open = 1.0;
    run(model, control, 10.0, state);
    CHECK(advance_chamber(model, control, 0.01, state).tip == doctest::Approx(0.0));
    CHECK(tube_pressure(model, state.tube_volume) > 50.0 * mmhg);
}

TEST_CASE("with the bottle shut a wound lets the eye go soft, a tight one does not") {
    ChamberModel model;
    ChamberControl control;
    control.tip_open = 0.0;
    ChamberState state = chamber_state(model, 50.0 * mmhg, 0.0);
    run(model, control, 60.0, state);
    CHECK(eye_pressure(model, state.eye_volume) < 1.0 * mmhg);
    CHECK(eye_pressure(model, state.eye_volume) >= 0.0);
    model.leak_conductance = 0.0;
    state = chamber_state(model, 50.0 * mmhg, 0.0);
    run(model, control, 60.0, state);
    CHECK(eye_pressure(model, state.eye_volume) == doctest::Approx(50.0 * mmhg).epsilon(1e-12));
}

TEST_CASE("ten minutes of any pedal and any occlusion: finite, in bounds, not a drop lost") {
    const ChamberModel model;
    Rng rng(7, "chamber");
    ChamberState state = chamber_state(model, 15.0 * mmhg, 0.0);
    const double start = stored(state);
    ChamberControl control = random_control(rng);
    double worst = 0.0;
    int hold = 0;
    int collapsed = 0;
    for (int i = 0; i < 60000; ++i) {
        if (hold-- == 0) {
            control = random_control(rng);
            hold = static_cast<int>(rng.integer(0, 49));
        }
        const ChamberTotals before = state.totals;
        const ChamberFlows flows = advance_chamber(model, control, 0.01, state);
        REQUIRE(check(model, state).ok());
        const double eye = eye_pressure(model, state.eye_volume);
        const double tube = tube_pressure(model, state.tube_volume);
        // Nothing exceeds what drives it: the highest bottle, the strongest vacuum, with a pump that only takes.
        REQUIRE(eye < bottle_pressure(model, 1500.0));
        REQUIRE(tube > -(700.0 + 1e-6) * mmhg);
        REQUIRE(tube < bottle_pressure(model, 1500.0));
        REQUIRE(flows.pump >= 0.0);
        REQUIRE(flows.leak >= 0.0);
        REQUIRE(flows.pump * 0.01 == doctest::Approx(state.totals.aspirated - before.aspirated).epsilon(1e-6));
        collapsed += eye < model.collapse_pressure ? 1 : 0;
        worst = std::max(worst, std::abs(stored(state) - start - supplied(state.totals)));
    }
    CHECK(state.totals.infused > 1000.0);
    CHECK(collapsed > 0);      // the run did reach the soft eye
    CHECK(collapsed < 60000);  // and left it
    CHECK(worst < 1e-8);       // of 1e5 mm^3 that went through
    MESSAGE("infused ", state.totals.infused, " mm^3, leaked ", state.totals.leaked, ", lost at most ", worst,
            "; soft for ", collapsed, " of 60000 steps");
}

TEST_CASE("all of it at once: steps of 10 ms against steps of 0.1 ms") {
    const ChamberModel model;
    Rng rng(11, "chamber");
    ChamberState coarse = chamber_state(model, 15.0 * mmhg, 0.0);
    ChamberState fine = coarse;
    double worst_eye = 0.0;
    double worst_tube = 0.0;
    for (int i = 0; i < 200; ++i) {
        const ChamberControl control = random_control(rng);
        for (int k = 0; k < 10; ++k) {
            advance_chamber(model, control, 0.01, coarse);
            for (int j = 0; j < 100; ++j) {
                advance_chamber(model, control, 0.0001, fine);
            }
            worst_eye = std::max(
                worst_eye, std::abs(eye_pressure(model, coarse.eye_volume) - eye_pressure(model, fine.eye_volume)));
            worst_tube = std::max(worst_tube, std::abs(tube_pressure(model, coarse.tube_volume) -
                                                       tube_pressure(model, fine.tube_volume)));
        }
    }
    MESSAGE("eye ", worst_eye / mmhg, " mmHg, tubing ", worst_tube / mmhg, " mmHg");
    CHECK(worst_eye < 0.5 * mmhg);   // 1 % of 50 mmHg
    CHECK(worst_tube < 4.0 * mmhg);  // 1 % of 400 mmHg
}

TEST_CASE("the corners of every range can be stepped by the longest step") {
    const double longest = 0.1;
    for (int corner = 0; corner < 64; ++corner) {
        const auto pick = [&](int bit, double low, double high) { return ((corner >> bit) & 1) != 0 ? high : low; };
        ChamberModel model;
        model.eye_compliance = pick(0, 0.0015, 0.075);
        model.eye_stiffening = pick(1, 0.0, 1.0);
        model.collapse_pressure = 100.0;
        model.tube_compliance = pick(2, 0.0005, 0.05);
        model.infusion_resistance = pick(3, 1.0, 100.0);
        model.tip_resistance = pick(4, 0.5, 200.0);
        model.tube_resistance = 0.0;
        model.leak_conductance = pick(5, 0.0, 0.5);
        model.pump_band = 100.0;
        REQUIRE(check(model).ok());
        Rng rng(static_cast<std::uint64_t>(corner), "corner");
        ChamberState state = chamber_state(model, 15.0 * mmhg, 0.0);
        const double start = stored(state);
        for (int i = 0; i < 200; ++i) {
            advance_chamber(model, random_control(rng), longest, state);
            const double eye = eye_pressure(model, state.eye_volume);
            REQUIRE(eye < 1.01 * bottle_pressure(model, 1500.0));
            REQUIRE(eye > -701.0 * mmhg);
            REQUIRE(std::abs(stored(state) - start - supplied(state.totals)) < 1e-8);
        }
    }
}

TEST_CASE("what cannot be is refused with the field, its value and its range") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(check(ChamberModel{}).ok());
    CHECK(check(ChamberControl{}).ok());
    CHECK(check(ChamberModel{}, ChamberState{}).ok());

    ChamberModel model;
    model.eye_compliance = 0.0;
    CHECK(refused(check(model)) == "chamber: eye_compliance is 0 (0.0015 to 0.075 mm^3/Pa)");
    model = {};
    model.tube_compliance = 0.0;
    CHECK(refused(check(model)) == "chamber: tube_compliance is 0 (0.0005 to 0.05 mm^3/Pa)");
    model = {};
    model.tip_resistance = nan;
    CHECK(refused(check(model)) == "chamber: tip_resistance is nan (0.5 to 200 Pa s/mm^3)");
    const std::vector<double ChamberModel::*> numbers = {&ChamberModel::eye_compliance,
                                                         &ChamberModel::collapse_pressure,
                                                         &ChamberModel::eye_stiffening,
                                                         &ChamberModel::tube_compliance,
                                                         &ChamberModel::infusion_resistance,
                                                         &ChamberModel::tip_resistance,
                                                         &ChamberModel::tube_resistance,
                                                         &ChamberModel::leak_conductance,
                                                         &ChamberModel::pump_band,
                                                         &ChamberModel::vent_resistance,
                                                         &ChamberModel::fluid_density,
                                                         &ChamberModel::rest_pressure,
                                                         &ChamberModel::area,
                                                         &ChamberModel::diaphragm_share,
                                                         &ChamberModel::half_hole_area};
    CHECK(numbers.size() * sizeof(double) == sizeof(ChamberModel));
    for (double ChamberModel::*number : numbers) {
        for (const double bad : {nan, infinity, -1.0}) {
            model = {};
            model.*number = bad;
            CHECK_FALSE(check(model).ok());
        }
    }

    ChamberControl control;
    control.bottle_height = 1501.0;
    CHECK(refused(check(control)) == "chamber control: bottle_height is 1501 (0 to 1500 mm)");
    for (double ChamberControl::*number : {&ChamberControl::bottle_height, &ChamberControl::pump_flow,
                                           &ChamberControl::vacuum_limit, &ChamberControl::tip_open}) {
        for (const double bad : {nan, infinity, -1.0}) {
            control = {};
            control.*number = bad;
            CHECK_FALSE(check(control).ok());
        }
    }

    ChamberState state;
    state.tube_volume = nan;
    CHECK(refused(check(ChamberModel{}, state)) ==
          "chamber state: tube_volume is nan (-112.5095633 to 112.5095633 mm^3)");
    state = {};
    state.totals.leaked = infinity;
    CHECK(refused(check(ChamberModel{}, state)) == "chamber state: leaked is inf (-1000000000 to 1000000000 mm^3)");

    CHECK(check_chamber_step(0.01).ok());
    CHECK(refused(check_chamber_step(5.0)) == "chamber: step is 5 (above 0 to 0.1 s)");
    CHECK_FALSE(check_chamber_step(0.0).ok());
    CHECK_FALSE(check_chamber_step(nan).ok());
}
