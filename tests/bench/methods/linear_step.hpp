// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to solve the linear system of an implicit step that ImplicitSolid does not use, on a reference case: for
// comparing their speed at equal residual. One linearised backward Euler step each (warped stiffness at the start).
#pragma once

#include <memory>
#include <vector>

#include "scenes/bodies.hpp"

namespace rhexis::bench {

enum class StepMethod {
    matrix_free_cg_25,    ///< the paper's: no matrix, 25 iterations whatever is left [Dequidt2013]
    matrix_free_cg,       ///< the same to the tolerance
    block_jacobi_pcg,     ///< assembled, preconditioned by the 3x3 blocks of the diagonal
    cholmod_simplicial,   ///< factored in every step
    cholmod_supernodal,   ///< factored in every step, through BLAS on one thread
    single_factor,        ///< our factor in single precision made in every step, a few iterations
    first_factor,         ///< that of the first step kept for ever
    first_factor_warped,  ///< the same, turned with the nodes [Courtecuisse2010]
};
const char* name_of(StepMethod method);
inline constexpr StepMethod all_step_methods[] = {StepMethod::matrix_free_cg_25,  StepMethod::matrix_free_cg,
                                                  StepMethod::block_jacobi_pcg,   StepMethod::cholmod_simplicial,
                                                  StepMethod::cholmod_supernodal, StepMethod::single_factor,
                                                  StepMethod::first_factor,       StepMethod::first_factor_warped};

class LinearStep {
public:
    LinearStep(const scenes::ReferenceCase& scene, StepMethod method, double tolerance);
    ~LinearStep();

    struct Report {
        int iterations = 0;
        double residual = 0.0;  ///< relative
    };
    /// One step under the moving load.
    Report advance();
    /// The load's total at the time of the next step relative to its largest.
    [[nodiscard]] const SolidState& state() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Force per node of a reference case at a time [s].
std::vector<Vec3> moving_load(const scenes::ReferenceCase& scene, double time_s);

}  // namespace rhexis::bench
