// SPDX-License-Identifier: GPL-3.0-or-later
// L D L^T of a sparse block matrix in double precision that follows changes of low rank [DavisHager2001], by CHOLMOD's
// Modify module. Spare rows at the end wait for nodes that come later.
#pragma once

#include <memory>
#include <span>

#include "math/block_matrix.hpp"

namespace rhexis::bench {

class UpdownFactor {
public:
    UpdownFactor();
    ~UpdownFactor();

    enum class Order {
        given,           ///< that of the rows
        minimum_degree,  ///< of the graph, anew; change() is not for this
    };

    /// Analyses and factors. spare: block rows with `diagonal` on theirs. False if the matrix is not positive definite.
    bool factor(const BlockPattern& pattern, const BlockValues& values, Order order, int spare, double diagonal);

    /// Adds a symmetric matrix over some block rows (ascending; 3 rows and columns each): what is positive of it by
    /// updates, then what is negative by downdates. False where that is not positive definite: there is no factor then.
    bool change(std::span<const int> rows, const MatX& value);

    /// x = A^-1 b; 3 numbers per row, spare ones too.
    void solve(std::span<const double> b, std::span<double> x);

    /// Of L.
    [[nodiscard]] long entries() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis::bench
