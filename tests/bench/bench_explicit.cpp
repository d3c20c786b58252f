// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_explicit.hpp"

#include "base/rng.hpp"
#include "bench/methods/matrix_free_product.hpp"
#include "bench/timing.hpp"
#include "math/random_vectors.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "scenes/bodies.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json product_row(const std::string& name, const SolidModel& model, const Timing& timing) {
    return {{"name", name},
            {"elements", model.coarse.tets.size()},
            {"nodes", model.coarse.nodes.size()},
            {"us", 1e6 * timing.seconds},
            {"ns_per_element", 1e9 * timing.seconds / static_cast<double>(model.coarse.tets.size())},
            {"spread", timing.spread}};
}

/// A state with strains of some per cent and motion, the same in every run.
SolidState stirred(const SolidModel& model) {
    SolidState state = rest_state(model);
    Rng rng(1, "stirred");
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        const Vec3 x = state.position[i];
        state.position[i] += Vec3(0.03 * x.y() * x.y() / 5.0, -0.02 * x.z(), 0.04 * x.x());
        state.velocity[i] = uniform3(rng) - Vec3::Constant(0.5);
    }
    return state;
}

nlohmann::json step_row(const SolidModel& model, ExplicitSolid& solid, const Timing& step, const Timing& product) {
    const double dt = 0.8 * solid.stable_step();
    return {{"elements", model.coarse.tets.size()},
            {"nodes", model.coarse.nodes.size()},
            {"us", 1e6 * step.seconds},
            {"product_us", 1e6 * product.seconds},
            {"ratio", step.seconds / product.seconds},
            {"stable_step_us", 1e6 * solid.stable_step()},
            {"steps_per_second", 1.0 / step.seconds},
            {"cpu_s_per_s", step.seconds / dt},
            {"spread", std::max(step.spread, product.spread)}};
}

nlohmann::json run_product(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<int> sizes = options.quick ? std::vector<int>{1000} : std::vector<int>{1000, 3000, 12000, 24000};
    for (const int size : sizes) {
        const SolidModel model = scenes::default_eye(size).lens;
        const MatrixFreeProduct product(model, rest_state(model));
        const std::vector<Vec3>& x = model.coarse.nodes;
        std::vector<Vec3> y;
        const Timing timing = time_interleaved({[&] { product.apply(x, y); }}, options.repeats)[0];
        rows.push_back(product_row("product/" + std::to_string(size), model, timing));
    }
    return rows;
}

/// One step without contact: forces, velocities, positions. The state drifts on while it is timed, as in use.
nlohmann::json run_step(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<int> sizes = options.quick ? std::vector<int>{1000} : std::vector<int>{1000, 3000, 12000, 24000};
    for (const int size : sizes) {
        SolidModel model = scenes::default_eye(size).lens;
        model.formulation = Formulation::linear;
        SolidModel nodal = model;
        nodal.formulation = Formulation::nodal_pressure;
        const SolidState state = stirred(model);
        const MatrixFreeProduct product(model, state);
        std::vector<Vec3> y;
        std::vector<ExplicitSolid> solids;
        std::vector<std::string> names;
        for (const SolidModel* kind : {&model, &nodal}) {
            for (const char* set : {"avx512", "avx2", "baseline"}) {
                Result<ExplicitSolid> solid = ExplicitSolid::create(*kind, set);
                if (solid.ok()) {
                    solids.push_back(std::move(solid).value());
                    solids.back().load(state);
                    names.push_back(std::string(kind == &nodal ? "nodal/" : "linear/") + set);
                }
            }
        }
        std::vector<std::function<void()>> turns{[&] { product.apply(state.position, y); }};
        for (ExplicitSolid& solid : solids) {
            const double dt = 0.8 * solid.stable_step();
            turns.emplace_back([&solid, dt] {
                solid.predict(dt, Vec3(0.0, 0.0, -9810.0), {});
                solid.move(dt);
            });
        }
        const std::vector<Timing> timings = time_interleaved(turns, options.repeats);
        for (std::size_t k = 0; k < solids.size(); ++k) {
            rows.push_back(step_row(model, solids[k], timings[k + 1], timings[0]));
            rows.back()["name"] = "explicit/" + std::to_string(size) + "/" + names[k];
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> explicit_cases() {
    return {
        {"explicit", "one explicit step of the patient's lens by instruction set, over the scalar product", run_step},
        {"product", "scalar double matrix-free stiffness product of the patient's lens: the unit of the others",
         run_product}};
}

}  // namespace rhexis::bench
