// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where to begin a solve of a system that is like the last ones: the best of what their solutions span,
// measured by the energy of the error [Fischer1998]. What is pushed smoothly moves smoothly, and some steps foretell
// the next to a few digits.
#pragma once

#include <span>
#include <vector>

#include "physics/solve/coupled_matrix.hpp"

namespace rhexis {

class PastSolutions {
public:
    void forget() { count_ = 0; }
    /// Whether there are some of so many numbers.
    [[nodiscard]] bool any(std::size_t size) const { return count_ > 0 && size_ == size; }

    /// x: what minimises the energy of the error of A x = b among all sums of the solutions kept. Of one that adds too
    /// little to later ones, or on which A is not positive definite, nothing is taken. image: A x. Only if
    /// any(b.size()).
    void project(const CoupledMatrix& matrix, std::span<const double> b, std::span<double> x, std::span<double> image);
    /// Keeps a solution, instead of the oldest if there are linear_kernel::many; one of another size instead of all.
    void keep(std::span<const double> x);

private:
    std::size_t size_ = 0;
    std::size_t count_ = 0;
    std::size_t last_ = 0;           ///< place of the last one; the one before it is one less, round
    std::vector<double> solutions_;  ///< side by side; those not there yet are zero
    std::vector<double> images_;
};

}  // namespace rhexis
