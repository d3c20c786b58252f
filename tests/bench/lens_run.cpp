// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lens_run.hpp"

#include <cmath>
#include <numbers>

#include "base/clock.hpp"
#include "base/threads.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "physics/solid/implicit_solid.hpp"

namespace rhexis::bench {
namespace {

constexpr double sample_s = 0.01;

std::vector<Vec3> scaled(const std::vector<Vec3>& load, double share) {
    std::vector<Vec3> result(load);
    for (Vec3& force : result) {
        force *= share;
    }
    return result;
}

int samples_of(const LoadHistory& history) { return static_cast<int>(std::lround(history.end_s / sample_s)); }

}  // namespace

double LoadHistory::share(double time_s) const {
    return time_s >= rise_s ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * time_s / rise_s);
}

LensRun run_explicit(const scenes::LensPoke& poke, double share_of_limit, const LoadHistory& history) {
    LensRun run;
    Result<ExplicitSolid> solid = ExplicitSolid::create(poke.lens, "");
    if (!solid) {
        run.failure = solid.error().text();
        return run;
    }
    SolidState state = rest_state(poke.lens);
    solid.value().load(state);
    const int substeps = static_cast<int>(std::ceil(sample_s / (share_of_limit * solid.value().stable_step())));
    const double dt = sample_s / substeps;
    const double start = process_cpu_seconds();
    for (int sample = 0; sample < samples_of(history); ++sample) {
        for (int k = 0; k < substeps; ++k) {
            const double time = sample * sample_s + (k + 1) * dt;
            solid.value().predict(dt, Vec3::Zero(), scaled(poke.nodal_load, history.share(time)));
            solid.value().move(dt);
        }
        if (!solid.value().finite()) {
            run.failure = "not finite";
            run.depth.clear();
            return run;
        }
        solid.value().store(state);
        run.depth.push_back(scenes::poke_depth(poke, state.position));
    }
    run.cpu_s_per_s = (process_cpu_seconds() - start) / history.end_s;
    return run;
}

LensRun run_implicit(const scenes::LensPoke& poke, double step_s, int newton, double tolerance,
                     const LoadHistory& history) {
    LensRun run;
    ThreadPool pool(1);
    Result<ImplicitSolid> solid = ImplicitSolid::create(poke.lens, pool);
    if (!solid) {
        run.failure = solid.error().text();
        return run;
    }
    ImplicitSettings settings;
    settings.max_newton = newton;
    settings.tolerance = tolerance;
    SolidState state = rest_state(poke.lens);
    SolidState next = state;
    std::vector<RigidUnknown> bodies;
    const int steps = static_cast<int>(std::lround(history.end_s / step_s));
    double next_sample = sample_s;
    const double start = process_cpu_seconds();
    for (int step = 1; step <= steps; ++step) {
        const double time = step * step_s;
        solid.value().step(state, Vec3::Zero(), scaled(poke.nodal_load, history.share(time)), step_s, settings, {},
                           bodies, next);
        std::swap(state, next);
        for (; next_sample <= time + 1e-9; next_sample += sample_s) {
            run.depth.push_back(scenes::poke_depth(poke, state.position));
        }
    }
    run.cpu_s_per_s = (process_cpu_seconds() - start) / history.end_s;
    if (!std::isfinite(run.depth.back())) {
        run.failure = "not finite";
        run.depth.clear();
    }
    return run;
}

double depth_error(const LensRun& run, double compliance, double total_load, const LoadHistory& history) {
    double sum = 0.0;
    for (std::size_t i = 0; i < run.depth.size(); ++i) {
        const double expected = history.share(static_cast<double>(i + 1) * sample_s);
        const double found = run.depth[i] / (compliance * total_load);
        sum += (found - expected) * (found - expected);
    }
    return run.depth.empty() ? INFINITY : std::sqrt(sum / static_cast<double>(run.depth.size()));
}

}  // namespace rhexis::bench
