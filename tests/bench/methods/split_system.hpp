// SPDX-License-Identifier: GPL-3.0-or-later
// The linear system of the first step after a split, A x = b, as ImplicitStep builds it: to be solved by several
// methods.
#pragma once

#include <memory>
#include <vector>

#include "physics/membrane/membrane_body.hpp"
#include "physics/solve/coupled_matrix.hpp"

namespace rhexis::bench {

using Mat9 = Eigen::Matrix<double, 9, 9>;

struct SplitSystem {
    const MembraneModel& model;
    const MembraneState& state;  ///< just after the split
    const MembraneBody& body;    ///< whose rows A has
    double dt;                   ///< [s]
    CoupledMatrix matrix;        ///< A, no rigid bodies [g]
    std::vector<double> b;       ///< 3 per row [g mm/s]

    [[nodiscard]] int rows() const { return body.rows(); }
};

/// The model, state and body must outlive the system.
SplitSystem assemble(const MembraneModel& model, const MembraneState& state, MembraneBody& body, double dt);

/// |b - A x| / |b|.
double true_residual(const SplitSystem& system, const std::vector<double>& x);

/// A triangle's share of A, rows and columns by its corners, inertia included; zero at nodes that do not move. A is the
/// sum of these, and the identity at nodes that do not move.
Mat9 triangle_share(const MembraneModel& model, const MembraneState& state, int triangle, double dt);

}  // namespace rhexis::bench
