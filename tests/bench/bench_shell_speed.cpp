// SPDX-License-Identifier: GPL-3.0-or-later
// What a step and a Newton iteration of a shell cost, on one thread.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "bench/timing.hpp"
#include "math/cholesky.hpp"
#include "math/pcg.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "physics/solve/factor_preconditioner.hpp"
#include "scenes/shells.hpp"

namespace rhexis::bench {
namespace {

/// 10 ms steps of the lifted disc, one linear solve each. set: instruction set, or empty for the best.
nlohmann::json steps_row(const BenchOptions& options, double tolerance, const std::string& set = {}) {
    const Result<scenes::LiftedDisc> scene = scenes::lifted_disc();
    const std::string name = std::string("shell_743/steps").append(set.empty() ? "" : "_").append(set);
    if (!scene.ok()) {
        return {{"name", name}, {"error_text", scene.error().text()}};
    }
    const scenes::LiftedDisc& disc = scene.value();
    Result<ShellStepper> made = ShellStepper::create(disc.model, set);
    if (!made.ok()) {
        return {{"name", name}, {"error_text", made.error().text()}};
    }
    ShellStepper& stepper = made.value();
    ShellState state = rest_state(disc.model);
    const ImplicitSettings settings{.tolerance = tolerance, .max_newton = 1};
    const int pieces = options.quick ? 1 : 8;
    const int each = options.quick ? 10 : disc.measured_steps / pieces;
    double time = 0.0;
    double residual = 0.0;
    double iterations = 0.0;
    double lift = 0.0;
    int factored = 0;
    const auto advance = [&](int steps) {
        double seconds = 0.0;
        for (int i = 0; i < steps; ++i) {
            time += disc.step_s;
            const ShellLoad load = scenes::disc_load(disc, scenes::moving_share(time));
            const double start = thread_cpu_seconds();
            const ImplicitReport report = stepper.step(state, load, disc.gravity, disc.step_s, settings, state);
            seconds += thread_cpu_seconds() - start;
            residual = std::max(residual, report.residual);
            iterations += report.linear_iterations;
            factored += report.factored ? 1 : 0;
            lift = std::max(lift, state.position[at(disc.lifted[0])].z());
        }
        return seconds / steps;
    };
    advance(options.quick ? 5 : disc.warm_up_steps);
    residual = iterations = factored = 0;
    std::vector<double> seconds;
    for (int piece = 0; piece < pieces; ++piece) {
        seconds.push_back(advance(each));
    }
    std::sort(seconds.begin(), seconds.end());
    const double median = seconds[seconds.size() / 2];
    const double steps = static_cast<double>(pieces) * each;
    return {{"name", name},
            {"elements", disc.model.mesh.triangles.size()},
            {"nodes", disc.model.mesh.nodes.size()},
            {"tolerance", tolerance},
            {"steps_per_second", 1.0 / median},
            {"fastest_steps_per_second", 1.0 / seconds.front()},
            {"slowest_steps_per_second", 1.0 / seconds.back()},
            {"cpu_s_per_s", median / disc.step_s},
            {"iterations", iterations / steps},
            {"refactored", factored / steps},
            {"largest_lift_mm", lift},
            {"error", residual},
            {"error_kind", "largest relative residual of a step"}};
}

/// The system of a step of the disc at one of its states.
class DiscSystem {
public:
    explicit DiscSystem(const scenes::LiftedDisc& disc)
        : linear_(*linear_kernel::choose({})),
          dt_(disc.step_s),
          body(disc.model, *shell_kernel::choose({})),
          matrix(body.pattern(), linear_) {}

    void place(const ShellState& state) {
        body.set_reference(state.rotation);
        position.assign(6 * state.position.size() + 1, 0.0);
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            Eigen::Map<Vec3>(position.data() + 6 * at(body.rank(static_cast<int>(n)))) = state.position[n];
        }
    }
    void evaluate_forces() { body.forces(position, force); }
    void assemble() {
        body.forces_and_stiffness(position, elastic_kernel::Mode::consistent, dt_ * dt_, force, matrix.solid());
        for (int i = 0; i < body.rows(); ++i) {
            add_block(matrix.solid(), body.pattern().diagonal[at(i)],
                      (body.moves()[at(i)] != 0 ? body.mass().inertia[at(i)] : 1.0) * Mat3::Identity());
        }
        mirror_upper(body.pattern(), matrix.solid());
    }
    /// Elastic forces and a push on every node.
    [[nodiscard]] std::vector<double> right() const {
        std::vector<double> result(matrix.size());
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] = body.free()[i] != 0 ? force[i] + (i % 6 == 2 ? 1.0 : 0.0) : 0.0;
        }
        return result;
    }

private:
    const linear_kernel::Kernel& linear_;
    double dt_;

public:
    ShellBody body;
    CoupledMatrix matrix;
    std::vector<double> position;
    std::vector<double> force;
};

/// Parts of a Newton iteration of a step, while the load grows; solves to 1e-6. A kept factor is that of the step
/// before.
nlohmann::json newton_row(const BenchOptions& options) {
    const Result<scenes::LiftedDisc> scene = scenes::lifted_disc();
    if (!scene.ok()) {
        return {{"name", "shell_743/newton"}, {"error_text", scene.error().text()}};
    }
    const scenes::LiftedDisc& disc = scene.value();
    ShellState state = rest_state(disc.model);
    ShellStepper stepper = std::move(ShellStepper::create(disc.model)).value();
    const auto step = [&](int i) {
        const ShellLoad load = scenes::disc_load(disc, scenes::moving_share(i * disc.step_s));
        stepper.step(state, load, disc.gravity, disc.step_s, {}, state);
    };
    for (int i = 0; i < 14; ++i) {
        step(i);
    }
    DiscSystem system(disc);
    system.place(state);
    system.assemble();
    const linear_kernel::Kernel& linear = *linear_kernel::choose({});
    FactorPreconditioner kept(system.body.pattern(), linear);
    kept.factor(system.matrix, FactorPreconditioner::Precision::single);
    step(14);
    system.place(state);
    system.assemble();
    const std::vector<double> right = system.right();
    std::vector<double> solution(right.size());
    const double tolerance = 1e-6 * std::sqrt(dot(right, right));
    FactorPreconditioner fresh(system.body.pattern(), linear);
    fresh.factor(system.matrix, FactorPreconditioner::Precision::single);
    PcgWork work;
    int iterations = 0;
    const auto solve = [&](FactorPreconditioner& with) {
        iterations = pcg(
                         right, tolerance, 500,
                         [&](std::span<const double> in, std::span<double> out) { system.matrix.multiply(in, out); },
                         [&](std::span<const double> r, std::span<double> z) { with.apply(r, z); }, solution,
                         PcgStart::zero, work)
                         .iterations;
        return iterations;
    };
    Cholesky simplicial(system.body.pattern(), CholeskyKind::simplicial);
    Cholesky supernodal(system.body.pattern(), CholeskyKind::supernodal);
    const std::vector<Timing> times = time_interleaved(
        {[&] { system.evaluate_forces(); }, [&] { system.assemble(); },
         [&] { fresh.factor(system.matrix, FactorPreconditioner::Precision::single); }, [&] { solve(fresh); },
         [&] {
             system.assemble();
             fresh.factor(system.matrix, FactorPreconditioner::Precision::single);
             solve(fresh);
         },
         [&] {
             system.evaluate_forces();
             solve(kept);
         },
         [&] { simplicial.factor(system.matrix.solid()); }, [&] { supernodal.factor(system.matrix.solid()); }},
        options.quick ? 1 : options.repeats);
    const auto ms = [&](std::size_t i) { return 1e3 * times[i].seconds; };
    return {{"name", "shell_743/newton"},
            {"elements", disc.model.mesh.triangles.size()},
            {"nodes", disc.model.mesh.nodes.size()},
            {"forces_ms", ms(0)},
            {"assembly_ms", ms(1)},
            {"factor_ms", ms(2)},
            {"solve_ms", ms(3)},
            {"iteration_ms", ms(4)},
            {"kept_iteration_ms", ms(5)},
            {"cholmod_simplicial_ms", ms(6)},
            {"cholmod_supernodal_ms", ms(7)},
            {"iterations", solve(fresh)},
            {"kept_iterations", solve(kept)},
            {"spread", times[4].spread},
            {"single_precision", fresh.precision() == FactorPreconditioner::Precision::single}};
}

}  // namespace

std::vector<BenchCase> shell_speed_cases() {
    return {{"shell_743", "10 ms steps of a lifted disc of 742 triangles, one solve to 1e-9; parts of an iteration",
             [](const BenchOptions& options) {
                 return nlohmann::json::array({steps_row(options, 1e-9), steps_row(options, 1e-6),
                                               steps_row(options, 1e-9, "avx2"), steps_row(options, 1e-9, "baseline"),
                                               newton_row(options)});
             }}};
}

}  // namespace rhexis::bench
