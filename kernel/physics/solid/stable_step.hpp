// SPDX-License-Identifier: GPL-3.0-or-later
// Largest eigenvalue of an operator that is only known by its product, for the step limit of explicit dynamics.
#pragma once

#include <functional>

#include "math/types.hpp"

namespace rhexis {

/// Largest eigenvalue of a symmetric positive semidefinite operator of `size` rows by `steps` Lanczos steps from a
/// fixed start, plus the residual of its vector: an estimate from above. product(x, y): y = A x.
double largest_eigenvalue(const std::function<void(const VecX&, VecX&)>& product, Eigen::Index size, int steps);

/// Step limit of v += dt a(x + lag v), x += dt v with a = -omega^2 x [s]: undamped 2 / omega.
double symplectic_limit(double omega_squared, double lag);

}  // namespace rhexis
