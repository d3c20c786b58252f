// SPDX-License-Identifier: GPL-3.0-or-later
// What methods have in common that keep a factor over several splits: its rows, when it is due, the iterations.
#pragma once

#include <optional>

#include "bench/methods/split_solver.hpp"
#include "math/linear_kernel.hpp"
#include "physics/solve/factor_preconditioner.hpp"

namespace rhexis::bench {

/// Nodes keep their numbers: rows of a factor are those of the sheet that it was made for, then the new nodes.
class KeptSplitSolver : public SplitSolver {
public:
    explicit KeptSplitSolver(int splits) : splits_(splits) {}
    Report solve(const SplitSystem& system, double tolerance, std::vector<double>& x) final;

protected:
    /// Makes the factor anew, of the system's matrix.
    virtual void renew(const SplitSystem& system) = 0;
    /// Takes over a split; new_nodes: since the factor was made. False: it cannot, a new factor is due.
    virtual bool follow(const SplitSystem& system, int new_nodes) = 0;
    /// z ~ A^-1 r in the factor's rows, 3 numbers each: the sheet's of then, then those of the new nodes.
    virtual void apply(std::span<const double> r, std::span<double> z) = 0;
    [[nodiscard]] virtual long entries() const = 0;

    [[nodiscard]] int row_of(int node) const {
        return node < old_nodes() ? row_of_[static_cast<std::size_t>(node)] : node;
    }
    [[nodiscard]] int old_nodes() const { return static_cast<int>(row_of_.size()); }
    [[nodiscard]] int splits() const { return splits_; }

private:
    void make_anew(const SplitSystem& system);
    bool prepare(const SplitSystem& system);
    void precondition(std::span<const double> r, std::span<double> z);

    int splits_;
    int age_ = 0;  ///< splits that the factor has served
    std::vector<int> row_of_;
    std::vector<int> place_;  ///< per row of the system: row of the factor; empty: the same
    std::vector<double> r_, z_;
    PcgWork work_;
};

/// The kernel's factor, in single precision, of a sheet of before.
class EarlierFactor {
public:
    /// As the kernel does at a new sheet: the order's postorder, analysis, factor.
    void make(const SplitSystem& system);
    void apply(std::span<const double> r, std::span<double> z) { factor_->apply(r, z); }
    [[nodiscard]] long entries() const;

private:
    BlockPattern pattern_;
    std::optional<FactorPreconditioner> factor_;
};

std::unique_ptr<SplitSolver> with_stale_factor(int splits);
std::unique_ptr<SplitSolver> with_updown(int splits);
std::unique_ptr<SplitSolver> with_woodbury(int splits);

/// Blocks of the diagonal, their mean [g].
double mean_diagonal(const SplitSystem& system);

/// Spare rows for the nodes that a split may add.
inline constexpr int most_new_nodes = 5;

}  // namespace rhexis::bench
