// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse Cholesky factor in single precision, made and applied by our own fixed-order loops: fast enough to be made
// every few steps, and the same bits on every machine, which a factor through BLAS is not. It preconditions; it is not
// meant to solve.
//
// Multifrontal: each panel gathers its part of the matrix and what its children left into a dense front, eliminates its
// own columns there and leaves the rest to its parent [Liu1992]. Panels keep the inverse of their triangle, so that
// solving is products alone. A front's rows below its pivots are eliminated where the factor is kept, and what is left
// is made where the parent looks for it, so that nothing is copied.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/aligned.hpp"
#include "math/block_matrix.hpp"
#include "math/linear_kernel.hpp"
#include "math/supernodes.hpp"

namespace rhexis {

class PackedFactor {
public:
    /// pattern: rows in an order of elimination; one that is postordered takes least memory. It must outlive this.
    PackedFactor(const BlockPattern& pattern, const linear_kernel::Kernel& kernel);

    /// Takes over another pattern, in the memory that is there; there is no factor then. row_now: if rows were added to
    /// the pattern before, each behind one whose neighbours it shares, where those before are now, ascending; or empty.
    void follow(const BlockPattern& pattern, std::span<const int> row_now = {});

    /// False if the matrix is not positive definite to single precision, or not finite. Entries must be within single
    /// precision's range (1e-30 to 1e30).
    bool factor(const BlockValues& values);
    [[nodiscard]] bool factored() const { return factored_; }

    /// x ~ A^-1 x in place; 4 numbers per row, the fourth 0.
    void solve(std::span<float> x);

    /// Multiply-adds of a factorisation and of a solve.
    [[nodiscard]] double factor_work() const { return factor_work_; }
    [[nodiscard]] double solve_work() const { return solve_work_; }

private:
    struct Child {
        int panel;
        int first_run;  ///< of runs_: its rows in the parent's front
        int end_run;
    };
    void lay_out();
    std::size_t lay_out_panels(int s, std::size_t size);
    void find_children();
    void find_places();
    void find_runs(const std::vector<int>& local, Child& child, int pivots);
    [[nodiscard]] linear_kernel::Front front_of(int s);
    void extend(int s, const linear_kernel::Front& front);
    void keep_panels(int s, const linear_kernel::Front& front);

    const BlockPattern* pattern_;
    const linear_kernel::Kernel* kernel_;
    Supernodes tree_;
    std::vector<linear_kernel::Panel> panels_;  ///< wide panels of the tree are cut into several
    std::vector<int> first_panel_;              ///< of each panel of the tree
    std::vector<int> nodes_;                    ///< block rows below each of panels_
    std::vector<Child> children_;               ///< of each panel of the tree, one after the other
    std::vector<int> first_child_;
    std::vector<linear_kernel::Run> runs_;
    std::vector<int> place_;  ///< of the entries of A right of the diagonal in the front of their column, by slots
    AlignedVector<float> values_;
    AlignedVector<float> pivots_;               ///< of the front
    AlignedVector<float> below_;                ///< of the front of a panel that is cut
    std::array<AlignedVector<float>, 2> rest_;  ///< what panels leave: stacks of every other level of the tree
    std::vector<std::size_t> rest_of_;          ///< per panel: in the stack of its level
    std::vector<std::uint8_t> level_;           ///< per panel: even or odd
    AlignedVector<float> work_;
    AlignedVector<float> inverse_;
    double factor_work_ = 0.0;
    double solve_work_ = 0.0;
    bool factored_ = false;
};

}  // namespace rhexis
