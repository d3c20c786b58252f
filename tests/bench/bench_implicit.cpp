// SPDX-License-Identifier: GPL-3.0-or-later
// Steps per second of 10 ms under the moving load of the reference cases, one linear solve a step to a relative
// residual of 1e-9, and what the same takes by other methods. Unit: the scalar matrix-free product of the same mesh,
// timed before, between and after.
#include "bench/bench_implicit.hpp"

#include <algorithm>
#include <fstream>

#include "base/clock.hpp"
#include "bench/methods/linear_step.hpp"
#include "bench/methods/matrix_free_product.hpp"
#include "bench/timing.hpp"
#include "physics/solid/implicit_solid.hpp"

namespace rhexis::bench {
namespace {

constexpr double tolerance = 1e-9;

double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    file >> total >> resident;
    return 4096.0 * resident;
}

struct Tally {
    double seconds = 0.0;
    int steps = 0;
    double iterations = 0.0;
    int newton = 0;
    int factored = 0;
    double residual = 0.0;  ///< largest
};

/// The product's time around work done in pieces.
class Unit {
public:
    explicit Unit(const SolidModel& model) : model_(&model), product_(model, rest_state(model)) {}
    void measure() {
        std::vector<Vec3> y;
        const Timing timing = time_interleaved({[&] { product_.apply(model_->coarse.nodes, y); }}, 5)[0];
        fastest_ = std::min(fastest_, timing.seconds);
        slowest_ = std::max(slowest_, timing.seconds);
    }
    [[nodiscard]] double seconds() const { return fastest_; }
    [[nodiscard]] double disagreement() const { return slowest_ / fastest_ - 1.0; }

private:
    const SolidModel* model_;
    MatrixFreeProduct product_;
    double fastest_ = 1e9;
    double slowest_ = 0.0;
};

nlohmann::json row_of(const std::string& name, const scenes::ReferenceCase& scene, const Tally& tally,
                      const Unit& unit) {
    const double each = tally.seconds / tally.steps;
    return {{"name", name},
            {"elements", scene.solid.coarse.tets.size()},
            {"nodes", scene.solid.coarse.nodes.size()},
            {"steps_per_second", 1.0 / each},
            {"cpu_s_per_s", each / scene.step_s},
            {"products_per_step", each / unit.seconds()},
            {"product_us", 1e6 * unit.seconds()},
            {"product_disagreement", unit.disagreement()},
            {"iterations", tally.iterations / tally.steps},
            {"newton_iterations", static_cast<double>(tally.newton) / tally.steps},
            {"refactored", static_cast<double>(tally.factored) / tally.steps},
            {"error", tally.residual},
            {"error_kind", "largest relative residual of a step"}};
}

/// As a scene's steps are (physics/solid/solid_stepper.cpp).
ImplicitSettings scene_settings(double force) {
    return {.tolerance = 0.03, .max_newton = 16, .newton_tolerance = 1e-7, .force_tolerance = force, .foretell = true};
}

Vec3 sum_of(const std::vector<Vec3>& forces) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& force : forces) {
        sum += force;
    }
    return sum;
}

class Run {
public:
    explicit Run(const scenes::ReferenceCase& scene)
        : scene_(scene),
          pool_(1),
          solid_(std::move(ImplicitSolid::create(scene.solid, pool_)).value()),
          state_(rest_state(scene.solid)) {}

    /// balanced_to: the residual force as a share of weight and load at which Newton's method ends, as a scene has it;
    /// 0: one linear solve.
    void advance(int steps, double balanced_to, Tally* tally) {
        const double weight = scene_.gravity.norm() * remaining_mass(scene_.solid, state_);
        ImplicitSettings settings{.tolerance = tolerance, .max_newton = 1, .foretell = true};
        for (int i = 0; i < steps; ++i) {
            time_ += scene_.step_s;
            const std::vector<Vec3> load = moving_load(scene_, time_);
            if (balanced_to > 0.0) {
                settings = scene_settings(balanced_to * (weight + sum_of(load).norm()));
            }
            const double start = thread_cpu_seconds();
            const ImplicitReport report =
                solid_.step(state_, scene_.gravity, load, scene_.step_s, settings, {}, none_, next_);
            const double end = thread_cpu_seconds();
            std::swap(state_, next_);
            if (tally != nullptr) {
                tally->seconds += end - start;
                tally->iterations += report.linear_iterations;
                tally->newton += report.newton_iterations;
                tally->factored += report.factored ? 1 : 0;
                const double residual = balanced_to > 0.0 ? report.force / settings.force_tolerance : report.residual;
                tally->residual = std::max(tally->residual, report.converged ? residual : 1.0);
                ++tally->steps;
            }
        }
    }

private:
    const scenes::ReferenceCase& scene_;
    ThreadPool pool_;
    ImplicitSolid solid_;
    SolidState state_, next_;
    std::vector<RigidUnknown> none_;
    double time_ = 0.0;
};

nlohmann::json run_reference(const std::string& name, double balanced_to, const BenchOptions& options) {
    const Result<scenes::ReferenceCase> scene = scenes::reference_case(name);
    if (!scene.ok()) {
        return nlohmann::json::array({{{"name", "implicit_" + name}, {"error_text", scene.error().text()}}});
    }
    const double before = resident_bytes();
    Unit unit(scene.value().solid);
    Run run(scene.value());
    run.advance(options.quick ? 5 : scene.value().warm_up_steps, balanced_to, nullptr);
    Tally tally;
    const int pieces = options.quick ? 1 : 8;
    const int steps = options.quick ? 10 : scene.value().measured_steps / pieces;
    unit.measure();
    for (int piece = 0; piece < pieces; ++piece) {
        run.advance(steps, balanced_to, &tally);
        unit.measure();
    }
    nlohmann::json row =
        row_of("implicit_" + name + (balanced_to > 0.0 ? "_balanced" : ""), scene.value(), tally, unit);
    if (balanced_to > 0.0) {
        row["error_kind"] = "largest force out of balance, over what is allowed";
    }
    row["memory_mb"] = (resident_bytes() - before) / 1e6;
    return nlohmann::json::array({row});
}

nlohmann::json run_methods(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const Result<scenes::ReferenceCase> scene = scenes::reference_case("lens_3000");
    if (!scene.ok()) {
        return nlohmann::json::array({{{"name", "implicit_methods"}, {"error_text", scene.error().text()}}});
    }
    for (const StepMethod method : all_step_methods) {
        Unit unit(scene.value().solid);
        LinearStep steps(scene.value(), method, tolerance);
        const int warm_up = options.quick ? 1 : 25;
        const int measured = options.quick ? 2 : 50;
        Tally tally;
        unit.measure();
        for (int i = 0; i < warm_up + measured; ++i) {
            const double start = thread_cpu_seconds();
            const LinearStep::Report report = steps.advance();
            if (i >= warm_up) {
                tally.seconds += thread_cpu_seconds() - start;
                tally.iterations += report.iterations;
                tally.residual = std::max(tally.residual, report.residual);
                ++tally.steps;
            }
        }
        unit.measure();
        rows.push_back(row_of(std::string("implicit_methods/") + name_of(method), scene.value(), tally, unit));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> implicit_cases() {
    const auto reference = [](const std::string& name, double balanced_to = 0.0) {
        return [name, balanced_to](const BenchOptions& options) { return run_reference(name, balanced_to, options); };
    };
    return {{"implicit_lens_3000", "10 ms steps of the reference lens, one solve to 1e-9", reference("lens_3000")},
            {"implicit_lens_12000", "the same, four times the elements", reference("lens_12000")},
            {"implicit_lens_3000_balanced", "the same, by Newton's method to 1e-4 of all forces, as a script has it",
             reference("lens_3000", 1e-4)},
            {"implicit_methods", "the same step by other methods, the paper's among them", run_methods}};
}

}  // namespace rhexis::bench
