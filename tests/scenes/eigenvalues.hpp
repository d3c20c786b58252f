// SPDX-License-Identifier: GPL-3.0-or-later
// Dense symmetric eigenvalues compiled once: Eigen's solver takes seconds to compile wherever it is instantiated.
#pragma once

#include "math/types.hpp"

namespace rhexis::scenes {

/// Of a symmetric matrix, ascending. Reads the lower triangle.
VecX eigenvalues(const MatX& symmetric);

}  // namespace rhexis::scenes
