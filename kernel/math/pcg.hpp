// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients with a preconditioner that may be inexact, such as a factor kept in single precision.
#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace rhexis {

/// Working vectors, kept so that a solve allocates nothing.
struct PcgWork {
    std::vector<double> residual, direction, image, preconditioned;

    void resize(std::size_t n) {
        for (std::vector<double>* v : {&residual, &direction, &image, &preconditioned}) {
            v->resize(n);
        }
    }
};

struct PcgResult {
    int iterations = 0;
    double residual = 0.0;  ///< |b - A x|, by recurrence
    bool converged = false;
    bool finite = true;
    bool definite = true;  ///< false: a direction without positive curvature was met; x is the best until then
};

/// Sum of products in a fixed order: eight running sums, then their sum.
double dot(std::span<const double> a, std::span<const double> b);

enum class PcgStart {
    zero,        ///< whatever x holds
    from_x,      ///< at x
    with_image,  ///< at x, and A x is in the work's image
};

/// Solves A x = b until |b - A x| <= tolerance (absolute). multiply(in, out): out = A in, A symmetric positive
/// definite; precondition(in, out): out ~ A^-1 in. Flexible form [Notay2000].
template <typename Multiply, typename Precondition>
PcgResult pcg(std::span<const double> b, double tolerance, int max_iterations, const Multiply& multiply,
              const Precondition& precondition, std::span<double> x, PcgStart start, PcgWork& work) {
    const std::size_t n = b.size();
    work.resize(n);
    PcgResult result;
    if (start == PcgStart::from_x) {
        multiply(x, work.image);
    }
    const bool started = start != PcgStart::zero;
    for (std::size_t i = 0; i < n; ++i) {
        work.residual[i] = started ? b[i] - work.image[i] : b[i];
        x[i] = started ? x[i] : 0.0;
    }
    result.residual = std::sqrt(dot(work.residual, work.residual));
    double old_curvature = 0.0;
    while (true) {
        result.finite = std::isfinite(result.residual);
        result.converged = result.residual <= tolerance;
        if (!result.finite || result.converged || result.iterations >= max_iterations) {
            return result;
        }
        precondition(work.residual, work.preconditioned);
        // conjugate to the last direction whatever the preconditioner did
        const double beta = result.iterations == 0 ? 0.0 : -dot(work.image, work.preconditioned) / old_curvature;
        for (std::size_t i = 0; i < n; ++i) {
            work.direction[i] = work.preconditioned[i] + beta * work.direction[i];
        }
        multiply(work.direction, work.image);
        const double curvature = dot(work.direction, work.image);
        if (!(curvature > 0.0)) {
            result.definite = false;
            return result;
        }
        const double alpha = dot(work.direction, work.residual) / curvature;
        for (std::size_t i = 0; i < n; ++i) {
            x[i] += alpha * work.direction[i];
            work.residual[i] -= alpha * work.image[i];
        }
        old_curvature = curvature;
        ++result.iterations;
        result.residual = std::sqrt(dot(work.residual, work.residual));
    }
}

}  // namespace rhexis
