// SPDX-License-Identifier: GPL-3.0-or-later
// CHOLMOD's factor in double precision, changed by each split. It is exactly that of the new sheet with the stiffness
// of when its triangles came into it; the sheet has moved since, which is left to the iterations.
#include <algorithm>

#include "base/index.hpp"
#include "bench/methods/kept_split_solver.hpp"
#include "bench/methods/sheet_change.hpp"
#include "bench/methods/updown_factor.hpp"

namespace rhexis::bench {
namespace {

class UpdownSolver final : public KeptSplitSolver {
public:
    using KeptSplitSolver::KeptSplitSolver;

private:
    void renew(const SplitSystem& system) override {
        spare_ = most_new_nodes * (splits() - 1);
        diagonal_ = mean_diagonal(system);
        known_ = system.rows();
        factor_.factor(system.body.pattern(), system.matrix.solid(), UpdownFactor::Order::given, spare_, diagonal_);
        if (splits() > 1) {
            change_.start(system);
        }
        r_.assign(3 * at(system.rows() + spare_), 0.0);
        z_ = r_;
    }

    bool follow(const SplitSystem& system, int new_nodes) override {
        if (new_nodes > spare_) {
            return false;
        }
        NodeMatrix change = change_.follow(system);
        std::vector<std::pair<int, int>> order;  // row, place in the change
        for (int i = 0; i < static_cast<int>(change.nodes.size()); ++i) {
            order.emplace_back(row_of(change.nodes[at(i)]), i);
            if (change.nodes[at(i)] >= known_) {
                change.value.block<3, 3>(3 * i, 3 * i) -= diagonal_ * Mat3::Identity();
            }
        }
        known_ = system.rows();
        std::sort(order.begin(), order.end());
        std::vector<int> rows;
        MatX sorted(change.value.rows(), change.value.cols());
        for (int a = 0; a < static_cast<int>(order.size()); ++a) {
            rows.push_back(order[at(a)].first);
            for (int b = 0; b < static_cast<int>(order.size()); ++b) {
                sorted.block<3, 3>(3 * a, 3 * b) =
                    change.value.block<3, 3>(3 * order[at(a)].second, 3 * order[at(b)].second);
            }
        }
        return factor_.change(rows, sorted);
    }

    void apply(std::span<const double> r, std::span<double> z) override {
        if (r_.size() == r.size()) {
            factor_.solve(r, z);
            return;
        }
        std::copy(r.begin(), r.end(), r_.begin());
        factor_.solve(r_, z_);
        std::copy(z_.begin(), z_.begin() + static_cast<std::ptrdiff_t>(z.size()), z.begin());
    }

    [[nodiscard]] long entries() const override { return factor_.entries(); }

    UpdownFactor factor_;
    SheetChange change_;
    int spare_ = 0;
    int known_ = 0;  ///< nodes whose spare row is in use, or that need none
    double diagonal_ = 0.0;
    std::vector<double> r_, z_;  ///< with the spare rows, where the residual is 0
};

}  // namespace

std::unique_ptr<SplitSolver> with_updown(int splits) { return std::make_unique<UpdownSolver>(splits); }

}  // namespace rhexis::bench
