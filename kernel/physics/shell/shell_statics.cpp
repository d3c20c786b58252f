// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_statics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/cholesky.hpp"
#include "math/pcg.hpp"
#include "math/rotation.hpp"
#include "physics/shell/shell_body.hpp"

namespace rhexis {
namespace {

constexpr double least_stride = 1.0 / 4096.0;  // of a step between loads, of the way between them
constexpr int most_strides = 300;
constexpr double position_ulp = 2.2e-16;

double length_of(const std::vector<double>& v) { return std::sqrt(dot(v, v)); }

}  // namespace

// Vectors hold three numbers per row of the body.
struct ShellStatics::Parts {
    Parts(const ShellModel& shell, const shell_kernel::Kernel& kernel, ShellTriangleMaker maker)
        : model(&shell), body(shell, kernel, maker), solver(body.pattern(), CholeskyKind::indefinite) {
        stiffness = zero_values(body.pattern());
    }

    [[nodiscard]] std::size_t size() const { return 3 * at(body.rows()); }
    void place(const ShellState& state);
    [[nodiscard]] std::vector<double> by_rows(const ShellLoad& load) const;
    void balance(const ShellState& state, double factor);
    bool factor_tangent(const ShellState& state);
    double largest_share(const std::vector<double>& step, double most_turn) const;
    void apply(const std::vector<double>& step, double share, ShellState& state) const;
    void advance(double share, bool predict, ShellState& state);
    double first_change(const std::vector<double>& by_load, const std::vector<Vec3>& before, double arc) const;
    double next_change(const std::vector<double>& by_load, const std::vector<double>& way, double arc) const;
    [[nodiscard]] double moved_dot(const std::vector<double>& a, const std::vector<double>& b) const;

    const ShellModel* model;
    ShellBody body;
    Cholesky solver;
    BlockValues stiffness;
    std::vector<double> load;  ///< at factor 1
    std::vector<double> position, force, residual, step;
    double relative = 0.0;  ///< residual over all forces
    double rounding = 0.0;  ///< what the residual cannot fall below
};

void ShellStatics::Parts::place(const ShellState& state) {
    body.set_reference(state.rotation);
    position.assign(size() + 1, 0.0);
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        Eigen::Map<Vec3>(position.data() + 6 * at(body.rank(static_cast<int>(n)))) = state.position[n];
    }
}

std::vector<double> ShellStatics::Parts::by_rows(const ShellLoad& of) const {
    std::vector<double> result(size(), 0.0);
    for (std::size_t n = 0; n < model->mesh.nodes.size(); ++n) {
        const std::size_t first = 6 * at(body.rank(static_cast<int>(n)));
        if (!of.force.empty()) {
            Eigen::Map<Vec3>(result.data() + first) = of.force[n];
        }
        if (!of.moment.empty()) {
            Eigen::Map<Vec3>(result.data() + first + 3) = of.moment[n];
        }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = body.free()[i] != 0 ? result[i] : 0.0;
    }
    return result;
}

void ShellStatics::Parts::balance(const ShellState& state, double factor) {
    place(state);
    body.forces_everywhere(position, force);
    residual.assign(size(), 0.0);
    double all = factor * factor * dot(load, load);
    for (std::size_t i = 0; i < residual.size(); ++i) {
        if (body.free()[i] != 0) {
            residual[i] = force[i] + factor * load[i];
        } else {
            all += force[i] * force[i];
        }
    }
    const double size = length_of(residual);
    relative = size <= rounding ? 0.0 : size / std::sqrt(all);
}

bool ShellStatics::Parts::factor_tangent(const ShellState& state) {
    place(state);
    body.forces_and_stiffness(position, elastic_kernel::Mode::consistent, 1.0, force, stiffness);
    for (std::size_t i = 0; i < size(); ++i) {
        if (body.free()[i] == 0) {
            stiffness[9 * at(body.pattern().diagonal[i / 3]) + 4 * (i % 3)] = 1.0;
        }
    }
    mirror_upper(body.pattern(), stiffness);
    // positions are known to an ulp, so forces to stiffness times that
    double sum = 0.0;
    for (std::size_t row = 0; row < at(body.rows()); row += 2) {
        sum += block_of(stiffness, body.pattern().diagonal[row]).squaredNorm() *
               Eigen::Map<const Vec3>(position.data() + 3 * row).squaredNorm();
    }
    rounding = position_ulp * std::sqrt(sum);
    return solver.factor(stiffness);
}

/// Goes a share of `step`; predict: and makes the next tangent with the stress that this leads to.
void ShellStatics::Parts::advance(double share, bool predict, ShellState& state) {
    for (double& value : step) {
        value *= share;
    }
    if (predict) {
        place(state);
        body.predict(position, step);
    }
    apply(step, 1.0, state);
}

/// Share of a step that turns no node further than allowed.
double ShellStatics::Parts::largest_share(const std::vector<double>& of, double most_turn) const {
    double most = 0.0;
    for (std::size_t i = 3; i < of.size(); i += 6) {
        most = std::max(most, Eigen::Map<const Vec3>(of.data() + i).squaredNorm());
    }
    const double turn = std::sqrt(most);
    return turn > most_turn ? most_turn / turn : 1.0;
}

void ShellStatics::Parts::apply(const std::vector<double>& by, double share, ShellState& state) const {
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        const double* const own = by.data() + 6 * at(body.rank(static_cast<int>(n)));
        state.position[n] += share * Eigen::Map<const Vec3>(own);
        state.rotation[n] = turned(state.rotation[n], share * Eigen::Map<const Vec3>(own + 3));
    }
}

/// Of movements alone.
double ShellStatics::Parts::moved_dot(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); i += 6) {
        sum += a[i] * b[i] + a[i + 1] * b[i + 1] + a[i + 2] * b[i + 2];
    }
    return sum;
}

/// Change of the load's factor that begins a step along a path, on the way it came. by_load: movement per factor.
double ShellStatics::Parts::first_change(const std::vector<double>& by_load, const std::vector<Vec3>& before,
                                         double arc) const {
    double onwards = 0.0;
    for (std::size_t n = 0; n < before.size(); ++n) {
        onwards += before[n].dot(Eigen::Map<const Vec3>(by_load.data() + 6 * at(body.rank(static_cast<int>(n)))));
    }
    const double forwards = before.empty() || onwards > 0.0 ? arc : -arc;
    return forwards / std::sqrt(moved_dot(by_load, by_load));
}

/// The change with which |way + step + change by_load| = arc: of the two, the one that turns back less. Not a number
/// where there is none.
double ShellStatics::Parts::next_change(const std::vector<double>& by_load, const std::vector<double>& way,
                                        double arc) const {
    std::vector<double> without = way;
    for (std::size_t i = 0; i < without.size(); ++i) {
        without[i] += step[i];
    }
    const double a = moved_dot(by_load, by_load);
    const double b = moved_dot(by_load, without);
    const double c = moved_dot(without, without) - arc * arc;
    const double root = std::sqrt(b * b - a * c);
    return (moved_dot(by_load, way) > 0.0 ? root - b : -root - b) / a;
}

ShellStatics::ShellStatics(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ShellStatics::~ShellStatics() = default;
ShellStatics::ShellStatics(ShellStatics&&) noexcept = default;
ShellStatics& ShellStatics::operator=(ShellStatics&&) noexcept = default;

Result<ShellStatics> ShellStatics::create(const ShellModel& model, ShellTriangleMaker maker) {
    if (Status status = check_shell(model); !status) {
        return status.error();
    }
    return ShellStatics(std::make_unique<Parts>(model, *shell_kernel::choose({}), maker));
}

ShellStaticReport ShellStatics::equilibrate(const ShellLoad& load, double factor, const ShellStaticSettings& settings,
                                            ShellState& state) {
    Parts& p = *parts_;
    ShellStaticReport report;
    ShellState trial = state;
    p.load = p.by_rows(load);
    p.step.assign(p.size(), 0.0);
    p.body.forget_prediction();
    p.rounding = 0.0;
    p.balance(trial, factor);
    for (;;) {
        report.residual = p.relative;
        report.converged = p.relative <= settings.tolerance;
        if (report.converged || report.iterations >= settings.max_iterations || !std::isfinite(p.relative) ||
            !p.factor_tangent(trial)) {
            break;
        }
        report.negative_pivots = p.solver.negative_pivots();
        p.solver.solve(p.residual, p.step);
        p.advance(p.largest_share(p.step, settings.most_turn), settings.predict, trial);
        ++report.iterations;
        p.balance(trial, factor);
    }
    if (report.converged) {
        state = std::move(trial);
    }
    return report;
}

ShellStaticReport ShellStatics::load_to(const ShellLoad& load, double from, double to,
                                        const ShellStaticSettings& settings, ShellState& state) {
    double reached = from;
    double stride = to - from;
    int iterations = 0;
    ShellStaticReport report;
    const double least = least_stride * std::abs(to - from);
    for (int k = 0; k < most_strides && std::abs(stride) >= least; ++k) {
        const bool last = std::abs(stride) >= std::abs(to - reached);
        const double goal = last ? to : reached + stride;
        ShellStaticSettings either = settings;
        for (const bool predict : {settings.predict, !settings.predict}) {
            either.predict = predict;
            report = equilibrate(load, goal, either, state);
            report.iterations = iterations += report.iterations;
            if (report.converged) {
                break;
            }
        }
        if (!report.converged) {
            stride *= 0.5;
            continue;
        }
        if (last) {
            return report;
        }
        reached = goal;
        stride *= 1.5;
    }
    report.converged = false;
    return report;
}

ShellStaticReport ShellStatics::follow(const ShellLoad& load, double arc, const ShellStaticSettings& settings,
                                       ShellPath& path) {
    Parts& p = *parts_;
    ShellStaticReport report;
    ShellPath trial = path;
    p.load = p.by_rows(load);
    std::vector<double> by_load(p.size());
    std::vector<double> way(p.size(), 0.0);
    p.step.assign(p.size(), 0.0);
    p.body.forget_prediction();
    while (!report.converged && report.iterations < settings.max_iterations && p.factor_tangent(trial.state)) {
        report.negative_pivots = p.solver.negative_pivots();
        p.solver.solve(p.load, by_load);
        double change = 0.0;  // of the load's factor
        if (report.iterations == 0) {
            change = p.first_change(by_load, path.way, arc);
        } else {
            p.solver.solve(p.residual, p.step);
            change = p.next_change(by_load, way, arc);
        }
        for (std::size_t i = 0; i < p.step.size(); ++i) {
            p.step[i] += change * by_load[i];
            way[i] += p.step[i];
        }
        p.advance(1.0, settings.predict, trial.state);
        trial.factor += change;
        ++report.iterations;
        p.balance(trial.state, trial.factor);
        report.residual = p.relative;
        report.converged = p.relative <= settings.tolerance;
        if (!std::isfinite(p.relative)) {
            break;
        }
    }
    if (report.converged) {
        trial.way.resize(trial.state.position.size());
        for (std::size_t n = 0; n < trial.way.size(); ++n) {
            trial.way[n] = trial.state.position[n] - path.state.position[n];
        }
        path = std::move(trial);
    }
    return report;
}

int ShellStatics::negative_pivots(const ShellState& state) {
    parts_->body.forget_prediction();
    return parts_->factor_tangent(state) ? parts_->solver.negative_pivots() : 0;
}

Vec6 ShellStatics::reaction(const ShellState& state, int node) {
    Parts& p = *parts_;
    p.place(state);
    p.body.forces_everywhere(p.position, p.force);
    Vec6 result = Eigen::Map<const Vec6>(p.force.data() + 6 * at(p.body.rank(node)));
    for (int i = 0; i < 6; ++i) {
        result[i] = p.body.free()[6 * at(p.body.rank(node)) + at(i)] != 0 ? 0.0 : result[i];
    }
    return result;
}

}  // namespace rhexis
