// SPDX-License-Identifier: GPL-3.0-or-later
// The unit that speeds are quoted in: y = K x of the corotational stiffness of a tetrahedral mesh, by elements, in
// plain scalar double, one thread. Rotations are taken once; the product uses the turned gradients g_a = R b_a:
//   A = sum_a x_a (x) g_a,  y_a += V (mu (A + A^T) + lambda tr A) g_a                                  [Mueller2004]
#pragma once

#include <array>
#include <vector>

#include "flow/solid.hpp"

namespace rhexis::bench {

class MatrixFreeProduct {
public:
    /// The warped tangent at the state; model.formulation must be linear.
    MatrixFreeProduct(const SolidModel& model, const SolidState& state);

    /// y = K x, without regard to fixed nodes. y is resized.
    void apply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const;

private:
    struct Element {
        std::array<int, 4> node;
        std::array<double, 9> gradient;  ///< g_1, g_2, g_3; g_0 is minus their sum
        double mu;                       ///< times volume
        double lambda;                   ///< times volume
    };
    std::vector<Element> elements_;
};

}  // namespace rhexis::bench
