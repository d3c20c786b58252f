// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.hpp"

namespace rhexis {

double largest_eigenvalue(const std::function<void(const VecX&, VecX&)>& product, Eigen::Index size, int steps) {
    if (size == 0) {
        return 0.0;
    }
    Rng rng(1, "largest eigenvalue");
    VecX now(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        now[i] = 2.0 * rng.uniform() - 1.0;
    }
    now /= now.norm();
    VecX before = VecX::Zero(size);
    VecX next(size);
    const int count = static_cast<int>(std::min<Eigen::Index>(steps, size));
    VecX diagonal(count);
    VecX off(count);
    int done = 0;
    for (double beta = 0.0; done < count;) {
        product(now, next);
        diagonal[done] = now.dot(next);
        next -= diagonal[done] * now + beta * before;
        beta = next.norm();
        off[done++] = beta;
        if (!(beta > 1e-9 * diagonal.head(done).cwiseAbs().maxCoeff())) {
            break;
        }
        before.swap(now);
        now = next / beta;
    }
    Eigen::SelfAdjointEigenSolver<MatX> ritz;
    ritz.computeFromTridiagonal(diagonal.head(done), off.head(done - 1));
    return ritz.eigenvalues()[done - 1] + off[done - 1] * std::abs(ritz.eigenvectors()(done - 1, done - 1));
}

double symplectic_limit(double omega_squared, double lag) {
    if (!(omega_squared > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    // both roots of z^2 - (2 - dt^2 w^2 - dt lag w^2) z + (1 - dt lag w^2) inside the circle: dt^2 + 2 lag dt < 4 / w^2
    return 4.0 / omega_squared / (lag + std::sqrt(lag * lag + 4.0 / omega_squared));
}

}  // namespace rhexis
