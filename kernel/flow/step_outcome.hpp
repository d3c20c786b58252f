// SPDX-License-Identifier: GPL-3.0-or-later
// physics -> session: how a step went, so that session can keep it, roll it back, or log it.
#pragma once

#include <string>
#include <vector>

#include "flow/membrane.hpp"
#include "flow/mesh_edit.hpp"

namespace rhexis {

struct SolidStepReport {
    bool explicit_used = false;
    int substeps = 1;
    int newton_iterations = 0;
    int solver_iterations = 0;
    double residual = 0.0;           ///< relative residual left by the implicit solve
    double stable_step_s = 0.0;      ///< explicit stability limit now [s]; 0 if unknown
    double kinetic_energy = 0.0;     ///< [nJ] (uN mm)
    double elastic_energy = 0.0;     ///< [nJ]
    int inverted = 0;                ///< tetrahedra with negative volume
    std::vector<BrokenFace> broken;  ///< faces that give way after this step: proposals to topology, ascending
};

struct MembraneStepReport {
    int substeps = 1;
    int newton_iterations = 0;
    int linear_iterations = 0;
    double force = 0.0;               ///< norm of the forces that do not balance at the end [uN]
    std::vector<TearProposal> tears;  ///< proposals to topology, by tips
    std::vector<PunctureProposal> punctures;
    std::vector<CutProposal> cuts;
    std::vector<NotchProposal> notches;
    std::vector<int> out;  ///< nodes that jaws held when they left the eye
};

struct ShellStepReport {
    int substeps = 1;
    int newton_iterations = 0;
    int linear_iterations = 0;
    /// What does not balance at the end, as a share of what did not at the start or of the forces of contact.
    double residual = 0.0;
    double deepest = 0.0;  ///< penetration over thickness
};

/// What made a step unacceptable.
enum class StepFailure { none, not_finite, not_converged, inverted };

struct StepOutcome {
    StepFailure failure = StepFailure::none;  ///< after all fallbacks; `none`: the new state is good
    int rollbacks = 0;                        ///< tries thrown away before this result
    std::vector<std::string> notes;           ///< one line per fallback, for the log
    std::vector<SolidStepReport> solids;
    std::vector<MembraneStepReport> membranes;
    std::vector<ShellStepReport> shells;
};

}  // namespace rhexis
