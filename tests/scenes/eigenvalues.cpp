// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace rhexis::scenes {

VecX eigenvalues(const MatX& symmetric) {
    return Eigen::SelfAdjointEigenSolver<MatX>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace rhexis::scenes
