// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "session/session.hpp"

namespace rhexis::bench {
namespace {

constexpr double arm = 2.0;          ///< of the probe about the lens's axis [mm]
constexpr double sinking = 1.0;      ///< time to go into the front [s]
constexpr double depth = 0.8;        ///< of its end in the tissue [mm]
constexpr double hand_speed = 22.5;  ///< [deg/s]: 90 degrees in 4 s
constexpr double front = 2.0;        ///< of the lens at the arm [mm]

/// Into the front off the axis, then along an arc about it.
DeviceSample hand_at(double time_s) {
    const double in = std::clamp(time_s / sinking, 0.0, 1.0);
    const double turned = std::max(0.0, time_s - sinking) * hand_speed * std::numbers::pi / 180.0;
    DeviceSample sample;
    sample.present = true;
    sample.pose.position = Vec3(arm * std::cos(turned), arm * std::sin(turned), front + 0.5 - in * (0.5 + depth));
    return sample;
}

double value(const Session& session, const char* name) {
    for (std::size_t i = 0; i < session.schema().size(); ++i) {
        if (session.schema()[i].name == name) {
            return session.observation().values[i];
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

nlohmann::json row(const std::string& name, double hand_deg, const Session& session, double mean_torque) {
    return {{"name", name},
            {"hand_deg", hand_deg},
            {"lens_deg", value(session, "lens.rotation_deg")},
            {"tool_torque_mNmm", mean_torque},
            {"zonule_torque_mNmm", value(session, "zonules.torque_mNmm")},
            {"zonule_load_mN", value(session, "zonules.load_mN")},
            {"zonule_strain", value(session, "zonules.strain")},
            {"bag_turn_deg", value(session, "bag.turn_deg")},
            {"slip_deg", value(session, "bag.slip_deg")},
            {"shift_mm", value(session, "lens.displacement_mm")}};
}

void turn(double freed, bool quick, nlohmann::json& rows) {
    SceneDescription scene;
    scene.patient.tetrahedra = quick ? 500 : 3000;
    scene.tissues = {"lens", "bag", "capsule", "iris", "cornea", "chamber"};
    scene.instruments = {"probe"};
    scene.settings["hydrodissection.freed"] = freed;
    Session session = std::move(Session::create(scene, 1)).value();
    const std::string name = std::string("rotation/freed ").append(std::to_string(std::lround(100.0 * freed))) + " %";
    const int first = static_cast<int>(std::lround(sinking / scene.step_s));
    const int every = static_cast<int>(std::lround(15.0 / hand_speed / scene.step_s));
    double torque = 0.0;
    for (int i = 1; i <= first + (quick ? 1 : 6) * every; ++i) {
        const DeviceSample sample = hand_at(i * scene.step_s);
        session.step({&sample, 1}, {});
        torque += value(session, "lens.tool_torque_mNmm") / every;
        if (i >= first && (i - first) % every == 0) {
            rows.push_back(row(name, 15.0 * (i - first) / every, session, i == first ? 0.0 : torque));
        }
        torque = i <= first || (i - first) % every == 0 ? 0.0 : torque;
    }
}

nlohmann::json run_rotation(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    for (const double freed : {0.0, 0.5, 0.9, 1.0}) {
        turn(freed, options.quick, rows);
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> rotation_cases() {
    return {
        {"rotation",
         "a probe sunk into the front turns the nucleus: torque, zonules and slip over the angle, by how much of the "
         "cortex is freed",
         run_rotation}};
}

}  // namespace rhexis::bench
