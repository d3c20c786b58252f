// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_phaco.hpp"

#include <cmath>

#include "base/clock.hpp"
#include "bench/chart.hpp"
#include "scenes/lens_press.hpp"
#include "session/session.hpp"

namespace rhexis::bench {
namespace {

constexpr double filling = 0.6;   ///< irrigation alone before the strokes [s]
constexpr double duration = 2.0;  ///< with the strokes [s]

/// What a stroke did, sampled every 20 ms.
struct Stroke {
    std::vector<double> removed;  ///< [mm^3]
    std::vector<double> force;    ///< of the tip on the lens, mean since the last sample [mN]
    std::vector<double> depth;    ///< of the chamber [mm]
    double cpu_s_per_s = 0.0;
    int elements = 0;
    std::string failure;
};

SceneDescription scene_of(int tetrahedra, double step_s, Advance advance) {
    SceneDescription scene;
    scene.patient.tetrahedra = tetrahedra;
    scene.instruments = {"phaco"};
    scene.step_s = step_s;
    scene.advance = advance;
    scene.tissues = {"lens", "bag", "capsule", "iris", "cornea"};
    if (advance != Advance::implicit) {
        scene.tissues.push_back("chamber");
    }
    return scene;
}

/// In front of the lens, then two strokes through its front at 3 mm/s, half a millimetre deep, with full ultrasound.
DeviceSample hand_at(double time_s) {
    DeviceSample sample;
    sample.present = true;
    sample.pose.orientation = Quat(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
    const double t = std::max(0.0, time_s - filling);
    const double way = std::fmod(3.0 * t, 2.1);
    sample.pose.position = Vec3(0.2, -1.2 + way, t > 0.0 ? 0.9 : 2.2);
    sample.pedal = t > 0.0 ? 3.0 : 1.0;
    return sample;
}

double value(const Session& session, const char* name) {
    for (std::size_t i = 0; i < session.schema().size(); ++i) {
        if (session.schema()[i].name == name) {
            return session.observation().values[i];
        }
    }
    return 0.0;
}

Stroke run_stroke(int tetrahedra, double step_s, Advance advance) {
    Result<Session> made = Session::create(scene_of(tetrahedra, step_s, advance), 1);
    Stroke stroke;
    if (!made) {
        stroke.failure = made.error().text();
        return stroke;
    }
    Session session = std::move(made).value();
    stroke.elements = static_cast<int>(session.world().solids[0].coarse.tets.size());
    const int every = static_cast<int>(std::lround(0.02 / step_s));
    const int steps = static_cast<int>(std::lround((filling + duration) / step_s));
    double force = 0.0;
    const double start = thread_cpu_seconds();
    for (int i = 1; i <= steps; ++i) {
        const DeviceSample sample = hand_at(i * step_s);
        const StepOutcome outcome = session.step({&sample, 1}, {});
        if (outcome.failure != StepFailure::none) {
            stroke.failure = "a step could not be solved";
            return stroke;
        }
        force += value(session, "phaco.force_mN");
        if (i % every == 0) {
            stroke.removed.push_back(value(session, "lens.removed_mm3"));
            stroke.force.push_back(force / every);
            stroke.depth.push_back(value(session, "chamber.depth_mm"));
            force = 0.0;
        }
    }
    stroke.cpu_s_per_s = (thread_cpu_seconds() - start) / (filling + duration);
    return stroke;
}

nlohmann::json row(const std::string& name, double step_s, const Stroke& stroke, const Stroke& finest) {
    nlohmann::json result = {{"name", name}, {"point", milliseconds(step_s)}, {"elements", stroke.elements}};
    if (!stroke.failure.empty()) {
        result["failure"] = stroke.failure;
        return result;
    }
    result["cpu_s_per_s"] = stroke.cpu_s_per_s;
    result["removed_mm3"] = stroke.removed.back();
    result["removed_error"] = std::abs(stroke.removed.back() - finest.removed.back()) / finest.removed.back();
    result["force_error"] = scenes::relative_difference(stroke.force, finest.force);
    if (name.find("implicit") == std::string::npos) {
        result["depth_error"] = scenes::relative_difference(stroke.depth, finest.depth);
    }
    result["error_kind"] = "against 24,000 tetrahedra in steps of 1 ms: volume at the end, rms of force and depth";
    return result;
}

nlohmann::json run_chart(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const Stroke finest = run_stroke(options.quick ? 1000 : 24000, options.quick ? 0.01 : 0.001, Advance::explicit_);
    for (const int size : {500, 1000, 3000, 6000, 12000}) {
        for (const double step_s : {0.02, 0.01, 0.005, 0.002}) {
            if (!options.quick || (size == 1000 && step_s > 0.005)) {
                rows.push_back(row("explicit", step_s, run_stroke(size, step_s, Advance::explicit_), finest));
            }
        }
        if (!options.quick && size <= 3000) {
            rows.push_back(row("implicit, no chamber", 0.01, run_stroke(size, 0.01, Advance::implicit), finest));
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> phaco_cases() {
    return {{"phaco",
             "two strokes with ultrasound: cost, and error of removed volume, tool force and chamber depth, over mesh, "
             "step and method",
             run_chart}};
}

}  // namespace rhexis::bench
