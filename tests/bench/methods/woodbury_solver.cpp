// SPDX-License-Identifier: GPL-3.0-or-later
// The factor of an earlier sheet A and what splits have changed since, D over the nodes that they touched (columns of
// P):
//   (A + P D P')^-1 = A^-1 - A^-1 P (I + D G)^-1 D P' A^-1,  G = P' A^-1 P                                [Hager1989]
// A has spare rows with a diagonal of its own for nodes to come. Each touched node costs three solves for its columns
// of G, once; each iteration two solves.
#include <Eigen/LU>
#include <algorithm>

#include "base/index.hpp"
#include "bench/methods/kept_split_solver.hpp"
#include "bench/methods/sheet_change.hpp"

namespace rhexis::bench {
namespace {

Eigen::Index three(int i) { return 3 * static_cast<Eigen::Index>(i); }

class WoodburySolver final : public KeptSplitSolver {
public:
    using KeptSplitSolver::KeptSplitSolver;

private:
    void renew(const SplitSystem& system) override {
        factor_.make(system);
        diagonal_ = mean_diagonal(system);
        touched_.clear();
        green_.resize(0, 0);
        sum_.resize(0, 0);
        small_.resize(0, 0);
        unit_.assign(3 * at(system.rows()), 0.0);
        column_ = unit_;
        if (splits() > 1) {
            change_.start(system);
        }
    }

    bool follow(const SplitSystem& system, int) override {
        const NodeMatrix change = change_.follow(system);
        std::vector<int> place;
        for (const int node : change.nodes) {
            place.push_back(place_of(row_of(node)));
        }
        for (int a = 0; a < static_cast<int>(place.size()); ++a) {
            for (int b = 0; b < static_cast<int>(place.size()); ++b) {
                sum_.block<3, 3>(three(place[at(a)]), three(place[at(b)])) +=
                    change.value.block<3, 3>(three(a), three(b));
            }
        }
        const MatX identity = MatX::Identity(sum_.rows(), sum_.cols());
        const MatX inner = (identity + sum_ * green_).partialPivLu().solve(sum_);
        small_ = 0.5 * (inner + inner.transpose());
        touched_values_.resize(small_.rows());
        return true;
    }

    /// Of a row among those touched, where it is put if it was not.
    int place_of(int row) {
        const auto found = std::find(touched_.begin(), touched_.end(), row);
        if (found != touched_.end()) {
            return static_cast<int>(found - touched_.begin());
        }
        const int place = static_cast<int>(touched_.size());
        touched_.push_back(row);
        const Eigen::Index size = three(place + 1);
        green_.conservativeResizeLike(MatX::Zero(size, size));
        sum_.conservativeResizeLike(MatX::Zero(size, size));
        for (int c = 0; c < 3; ++c) {
            if (row >= old_nodes()) {
                green_(three(place) + c, three(place) + c) = 1.0 / diagonal_;
                sum_(three(place) + c, three(place) + c) = -diagonal_;
            } else {
                add_column(row, c, place);
            }
        }
        return place;
    }

    void add_column(int row, int c, int place) {
        unit_[3 * at(row) + at(c)] = 1.0;
        factor_.apply(unit_, column_);
        unit_[3 * at(row) + at(c)] = 0.0;
        for (int other = 0; other <= place; ++other) {
            const int own = touched_[at(other)];
            for (int r = 0; r < 3 && own < old_nodes(); ++r) {
                const double value = column_[3 * at(own) + at(r)];
                green_(three(other) + r, three(place) + c) = value;
                green_(three(place) + c, three(other) + r) = value;
            }
        }
    }

    void apply_earlier(std::span<const double> r, std::span<double> z) {
        factor_.apply(r, z);
        for (std::size_t i = 3 * at(old_nodes()); i < r.size(); ++i) {
            z[i] = r[i] / diagonal_;
        }
    }

    void apply(std::span<const double> r, std::span<double> z) override {
        apply_earlier(r, z);
        if (touched_.empty()) {
            return;
        }
        for (int i = 0; i < static_cast<int>(touched_.size()); ++i) {
            touched_values_.segment<3>(three(i)) = Eigen::Map<const Vec3>(z.data() + 3 * at(touched_[at(i)]));
        }
        const VecX pull = small_ * touched_values_;
        corrected_.assign(r.begin(), r.end());
        for (int i = 0; i < static_cast<int>(touched_.size()); ++i) {
            Eigen::Map<Vec3>(corrected_.data() + 3 * at(touched_[at(i)])) -= pull.segment<3>(three(i));
        }
        apply_earlier(corrected_, z);
    }

    [[nodiscard]] long entries() const override { return factor_.entries() + static_cast<long>(small_.size()); }

    EarlierFactor factor_;
    SheetChange change_;
    double diagonal_ = 0.0;     ///< of spare rows
    std::vector<int> touched_;  ///< rows of the factor
    MatX green_;                ///< G
    MatX sum_;                  ///< D
    MatX small_;                ///< (I + D G)^-1 D
    VecX touched_values_;
    std::vector<double> unit_, column_, corrected_;
};

}  // namespace

std::unique_ptr<SplitSolver> with_woodbury(int splits) { return std::make_unique<WoodburySolver>(splits); }

}  // namespace rhexis::bench
