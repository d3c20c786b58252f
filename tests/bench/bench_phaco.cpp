// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_phaco.hpp"

#include <cmath>

#include "base/clock.hpp"
#include "bench/chart.hpp"
#include "scenes/lens_press.hpp"
#include "session/session.hpp"

namespace rhexis::bench {
namespace {

constexpr double filling = 1.0;   ///< irrigation alone before the strokes [s]
constexpr double sample_s = 0.1;  ///< what is felt is a mean: a mouth that grips and lets go does so by chance

/// A way of the tip with how far the pedal is down, in front of the lens and through it. [mm]
struct Leg {
    Vec3 to;
    double speed = 0.0;  ///< [mm/s]
    double pedal = 1.0;
};

/// Two layers, each of two strokes side by side, as a groove is sculpted: 3.5 mm/s, 0.35 mm a layer, each back over the
/// lens. Nothing leaps: what a hand cannot do no mesh resolves.
std::vector<Leg> way_of_tip() {
    std::vector<Leg> legs;
    for (int i = 0; i < 4; ++i) {
        const double x = i % 2 == 0 ? -0.3 : 0.3;
        const double floor = i < 2 ? 0.85 : 0.5;  // front of the lens: 1.25
        legs.push_back({Vec3(x, -1.4, 1.6), 7.0, 1.0});
        legs.push_back({Vec3(x, -1.4, 1.15), 4.0, 3.0});
        legs.push_back({Vec3(x, 0.0, floor), 3.5, 3.0});
        legs.push_back({Vec3(x, 1.8, floor), 3.5, 3.0});
        legs.push_back({Vec3(x, 1.8, 1.6), 7.0, 1.0});
    }
    return legs;
}

/// What a stroke did, sampled every 0.1 s.
struct Stroke {
    std::vector<double> removed;  ///< [mm^3]
    std::vector<double> force;    ///< of the tip on the lens, mean since the last sample [mN]
    std::vector<double> depth;    ///< of the chamber [mm]
    double cpu_s_per_s = 0.0;
    int elements = 0;
    std::string failure;
};

SceneDescription scene_of(int tetrahedra, double step_s, Advance advance, bool by_points) {
    SceneDescription scene;
    scene.patient.tetrahedra = tetrahedra;
    scene.instruments = {"phaco"};
    scene.step_s = step_s;
    scene.advance = advance;
    scene.lens_by_points = by_points;
    scene.tissues = {"lens", "bag", "capsule", "iris", "cornea"};
    scene.settings = {{"machine.bottle_cm", 75.0}, {"machine.flow_ml_min", 22.0}, {"machine.vacuum_mmhg", 80.0}};
    if (advance != Advance::implicit) {
        scene.tissues.push_back("chamber");
    }
    return scene;
}

/// In front of the lens while the chamber fills, then along the way.
DeviceSample hand_at(double time_s, const std::vector<Leg>& way) {
    DeviceSample sample;
    sample.present = true;
    sample.pose.orientation = Quat(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
    sample.pose.position = Vec3(-0.3, -1.4, 2.2);
    sample.pedal = 1.0;
    double left = time_s - filling;
    for (const Leg& leg : way) {
        if (left <= 0.0) {
            break;
        }
        const Vec3 from = sample.pose.position;
        const double needs = (leg.to - from).norm() / leg.speed;
        sample.pose.position = from + std::min(1.0, left / needs) * (leg.to - from);
        sample.pedal = leg.pedal;
        left -= needs;
    }
    return sample;
}

double duration_of(const std::vector<Leg>& way) {
    Vec3 from = hand_at(0.0, way).pose.position;
    double sum = filling;
    for (const Leg& leg : way) {
        sum += (leg.to - from).norm() / leg.speed;
        from = leg.to;
    }
    return sum;
}

double value(const Session& session, const char* name) {
    for (std::size_t i = 0; i < session.schema().size(); ++i) {
        if (session.schema()[i].name == name) {
            return session.observation().values[i];
        }
    }
    return 0.0;
}

Stroke run_stroke(int tetrahedra, double step_s, Advance advance, bool by_points = true) {
    Result<Session> made = Session::create(scene_of(tetrahedra, step_s, advance, by_points), 1);
    Stroke stroke;
    if (!made) {
        stroke.failure = made.error().text();
        return stroke;
    }
    Session session = std::move(made).value();
    stroke.elements = static_cast<int>(session.world().solids[0].coarse.tets.size());
    const std::vector<Leg> way = way_of_tip();
    const double duration = duration_of(way);
    const int every = static_cast<int>(std::lround(sample_s / step_s));
    const int steps = static_cast<int>(std::lround(duration / step_s));
    double force = 0.0;
    const double start = thread_cpu_seconds();
    for (int i = 1; i <= steps; ++i) {
        const DeviceSample sample = hand_at(i * step_s, way);
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
    stroke.cpu_s_per_s = (thread_cpu_seconds() - start) / duration;
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
    result["force_error"] = rms_share(stroke.force, finest.force);
    if (name.find("implicit") == std::string::npos) {
        result["depth_error"] = scenes::relative_difference(stroke.depth, finest.depth);
    }
    result["error_kind"] =
        "against 24,000 tetrahedra in steps of 1 ms: volume at the end; force in means over 0.1 s, rms "
        "as a share of the greatest; depth, rms";
    return result;
}

nlohmann::json run_chart(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const Stroke finest = run_stroke(options.quick ? 1000 : 24000, options.quick ? 0.01 : 0.001, Advance::explicit_);
    for (const int size : {500, 1000, 2000, 3000, 4500, 6000, 12000}) {
        for (const double step_s : {0.02, 0.01, 0.005, 0.002}) {
            if (!options.quick || (size == 1000 && step_s > 0.005)) {
                rows.push_back(row("explicit", step_s, run_stroke(size, step_s, Advance::explicit_), finest));
            }
        }
        if (options.quick) {
            continue;
        }
        rows.push_back(row("explicit, by vertices", 0.01, run_stroke(size, 0.01, Advance::explicit_, false), finest));
        if (size <= 3000) {
            rows.push_back(row("implicit, no chamber", 0.01, run_stroke(size, 0.01, Advance::implicit), finest));
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> phaco_cases() {
    return {
        {"phaco",
         "four strokes with ultrasound: cost, and error of removed volume, tool force and chamber depth, over mesh, "
         "step and method",
         run_chart}};
}

}  // namespace rhexis::bench
