// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/anew_solver.hpp"

#include <cmath>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/methods/kernel_factor.hpp"
#include "bench/methods/updown_factor.hpp"
#include "math/cholesky.hpp"
#include "physics/solve/factor_preconditioner.hpp"

namespace rhexis::bench {
namespace {

void copy_rows(const std::vector<double>& from, const ElasticBody& of_from, const ElasticBody& of_to,
               std::vector<double>& to) {
    to.resize(from.size());
    for (std::size_t row = 0; row < at(of_to.rows()); ++row) {
        const std::size_t other = at(of_from.row_of()[at(of_to.node_of()[row])]);
        Eigen::Map<Vec3>(to.data() + 3 * row) = Eigen::Map<const Vec3>(from.data() + 3 * other);
    }
}

class InSingle final : public SplitSolver {
public:
    Report solve(const SplitSystem& given, double tolerance, std::vector<double>& x) override {
        // the kernel would fill the matrix in its new order: that copy is not counted
        MembraneBody body(given.model, given.state.sheet);
        const SplitSystem own = assemble(given.model, given.state, body, given.dt);
        const linear_kernel::Kernel& kernel = *linear_kernel::choose();
        Report report;
        const double start = thread_cpu_seconds();
        elimination_order(node_pattern(given));
        FactorPreconditioner factor(body.pattern(), kernel);
        factor.factor(own.matrix, FactorPreconditioner::Precision::single);
        const double factored = thread_cpu_seconds();
        own_x_.resize(own.b.size());
        report.iterations = iterate(own, tolerance, factor, own_x_, work_);
        report.solve_s = thread_cpu_seconds() - factored;
        report.factor_s = factored - start;
        report.entries = factor_entries(body.pattern());
        report.factored = true;
        copy_rows(own_x_, body, given.body, x);
        return report;
    }

private:
    std::vector<double> own_x_;
    PcgWork work_;
};

class InDouble final : public SplitSolver {
public:
    Report solve(const SplitSystem& system, double tolerance, std::vector<double>& x) override {
        Report report;
        const double start = thread_cpu_seconds();
        factor_.factor(system.body.pattern(), system.matrix.solid(), UpdownFactor::Order::minimum_degree, 0, 0.0);
        const double factored = thread_cpu_seconds();
        x.resize(system.b.size());
        const double size = std::sqrt(dot(system.b, system.b));
        const PcgResult result = pcg(
            system.b, tolerance * size, 100,
            [&](std::span<const double> in, std::span<double> out) { system.matrix.multiply(in, out); },
            [&](std::span<const double> r, std::span<double> z) { factor_.solve(r, z); }, x, PcgStart::zero, work_);
        report.solve_s = thread_cpu_seconds() - factored;
        report.factor_s = factored - start;
        report.iterations = result.iterations;
        report.entries = factor_.entries();
        report.factored = true;
        return report;
    }

private:
    UpdownFactor factor_;
    PcgWork work_;
};

}  // namespace

std::unique_ptr<SplitSolver> anew_in_single() { return std::make_unique<InSingle>(); }
std::unique_ptr<SplitSolver> anew_in_double() { return std::make_unique<InDouble>(); }

}  // namespace rhexis::bench
