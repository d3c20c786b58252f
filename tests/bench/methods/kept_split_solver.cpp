// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/kept_split_solver.hpp"

#include <cmath>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/methods/kernel_factor.hpp"

namespace rhexis::bench {
namespace {

constexpr int patience = 40;  // iterations after which an old factor is given up; a new one costs about 30
constexpr int most_iterations = 1000;

}  // namespace

void KeptSplitSolver::make_anew(const SplitSystem& system) {
    row_of_ = system.body.row_of();
    place_.clear();
    renew(system);
    age_ = 1;
}

/// True: the factor was made anew.
bool KeptSplitSolver::prepare(const SplitSystem& system) {
    if (age_ == 0 || age_ >= splits_ || !follow(system, system.rows() - old_nodes())) {
        make_anew(system);
        return true;
    }
    ++age_;
    place_.clear();
    for (const int node : system.body.node_of()) {
        place_.push_back(row_of(node));
    }
    return false;
}

void KeptSplitSolver::precondition(std::span<const double> r, std::span<double> z) {
    if (place_.empty()) {
        apply(r, z);
        return;
    }
    r_.resize(r.size());
    z_.resize(r.size());
    for (std::size_t row = 0; row < place_.size(); ++row) {
        Eigen::Map<Vec3>(r_.data() + 3 * at(place_[row])) = Eigen::Map<const Vec3>(r.data() + 3 * row);
    }
    apply(r_, z_);
    for (std::size_t row = 0; row < place_.size(); ++row) {
        Eigen::Map<Vec3>(z.data() + 3 * row) = Eigen::Map<const Vec3>(z_.data() + 3 * at(place_[row]));
    }
}

SplitSolver::Report KeptSplitSolver::solve(const SplitSystem& system, double tolerance, std::vector<double>& x) {
    Report report;
    x.resize(system.b.size());
    const double target = tolerance * std::sqrt(dot(system.b, system.b));
    const auto iterate = [&](int limit, bool started) {
        const double start = thread_cpu_seconds();
        const PcgResult result = pcg(
            system.b, target, limit,
            [&](std::span<const double> in, std::span<double> out) { system.matrix.multiply(in, out); },
            [&](std::span<const double> r, std::span<double> z) { precondition(r, z); }, x,
            started ? PcgStart::from_x : PcgStart::zero, work_);
        report.solve_s += thread_cpu_seconds() - start;
        report.iterations += result.iterations;
        return result.converged;
    };
    const double start = thread_cpu_seconds();
    report.factored = prepare(system);
    report.factor_s = thread_cpu_seconds() - start;
    if (!iterate(report.factored ? most_iterations : patience, false) && !report.factored) {
        const double again = thread_cpu_seconds();
        make_anew(system);
        report.factor_s += thread_cpu_seconds() - again;
        report.factored = true;
        iterate(most_iterations, std::isfinite(dot(x, x)));
    }
    report.entries = entries();
    return report;
}

void EarlierFactor::make(const SplitSystem& system) {
    pattern_ = system.body.pattern();
    factor_.emplace(pattern_, *linear_kernel::choose());
    factor_->factor(system.matrix, FactorPreconditioner::Precision::single);
}

long EarlierFactor::entries() const { return factor_entries(pattern_); }

double mean_diagonal(const SplitSystem& system) {
    double sum = 0.0;
    for (int row = 0; row < system.rows(); ++row) {
        sum += block_of(system.matrix.solid(), system.body.pattern().diagonal[at(row)]).trace() / 3.0;
    }
    return sum / system.rows();
}

}  // namespace rhexis::bench
