// SPDX-License-Identifier: GPL-3.0-or-later
// The factor of an earlier sheet; nodes that are new since then by their blocks of the diagonal.
#include <Eigen/LU>

#include "base/index.hpp"
#include "bench/methods/kept_split_solver.hpp"

namespace rhexis::bench {
namespace {

class StaleSolver final : public KeptSplitSolver {
public:
    using KeptSplitSolver::KeptSplitSolver;

private:
    void renew(const SplitSystem& system) override {
        factor_.make(system);
        inverse_.clear();
    }

    bool follow(const SplitSystem& system, int new_nodes) override {
        inverse_.clear();
        for (int i = 0; i < new_nodes; ++i) {
            const int row = system.body.row_of()[at(old_nodes() + i)];
            inverse_.push_back(block_of(system.matrix.solid(), system.body.pattern().diagonal[at(row)]).inverse());
        }
        return true;
    }

    void apply(std::span<const double> r, std::span<double> z) override {
        factor_.apply(r, z);
        for (std::size_t i = 0; i < inverse_.size(); ++i) {
            const std::size_t first = 3 * (at(old_nodes()) + i);
            Eigen::Map<Vec3>(z.data() + first) = inverse_[i] * Eigen::Map<const Vec3>(r.data() + first);
        }
    }

    [[nodiscard]] long entries() const override { return factor_.entries() + 9 * static_cast<long>(inverse_.size()); }

    EarlierFactor factor_;
    std::vector<Mat3> inverse_;  ///< per new node
};

}  // namespace

std::unique_ptr<SplitSolver> with_stale_factor(int splits) { return std::make_unique<StaleSolver>(splits); }

}  // namespace rhexis::bench
