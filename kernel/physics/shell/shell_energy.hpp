// SPDX-License-Identifier: GPL-3.0-or-later
// Where the energy of a thin shell is and where a step takes it: for tests and measurements, not inside steps.
#pragma once

#include <vector>

#include "energy/shell_triangle.hpp"
#include "flow/shell.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {

/// [nJ]
struct ShellEnergy {
    double kinetic = 0.0;
    double elastic = 0.0;  ///< in the spring of the material's modulus
    double branch = 0.0;   ///< in that of the relaxing branch

    [[nodiscard]] double all() const { return kinetic + elastic + branch; }
};

/// Of one step [nJ]: external + renewed = gain + contact + friction + viscosity + drag + damping + integrator + rest.
/// Every one but the rest is found on its own.
struct ShellStepEnergy {
    double external = 0.0;    ///< brought by loads, weight and instruments
    double gain = 0.0;        ///< of all()
    double contact = 0.0;     ///< gain of what the springs of contact store
    double friction = 0.0;    ///< taken by it
    double viscosity = 0.0;   ///< taken by the branch's dashpot, for a deformation that goes evenly over the step
    double drag = 0.0;        ///< taken by the fluid
    double damping = 0.0;     ///< taken by Rayleigh damping of the mass
    double integrator = 0.0;  ///< taken by backward Euler from inertia and all springs, of contact only with accounts
    double renewed = 0.0;     ///< brought by springs of contact that were looked for anew, with accounts
    double rest = 0.0;        ///< work of forces that did not balance, Rayleigh damping of the stiffness
};

class ShellLedger {
public:
    /// The model must pass check_shell and outlive this.
    explicit ShellLedger(const ShellModel& model);

    [[nodiscard]] ShellEnergy energy(const ShellState& state) const;
    /// contact: of this step; stored_before: in its springs at the start.
    [[nodiscard]] ShellStepEnergy step(const ShellState& before, const ShellState& after, const ShellLoad& load,
                                       const Vec3& gravity, double dt, const ShellContactWork& contact = {},
                                       double stored_before = 0.0) const;
    /// Of every triangle, 15 numbers each: the branch of a shell that came to this state at once from rest.
    [[nodiscard]] std::vector<double> deformation(const ShellState& state) const;

private:
    [[nodiscard]] std::vector<double> way_of_deformation(const ShellState& before, const ShellState& after,
                                                         double dt) const;
    void flow(const ShellState& before, const ShellState& after, double dt, ShellStepEnergy& result) const;

    const ShellModel* model_;
    std::vector<ShellTriangle> triangle_;
    std::vector<double> area_;     ///< by nodes: a third of each of their triangles [mm^2]
    std::vector<double> mass_;     ///< likewise [g]
    std::vector<double> inertia_;  ///< likewise, against turning [g mm^2]
};

}  // namespace rhexis
