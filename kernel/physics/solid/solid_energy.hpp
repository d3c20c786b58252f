// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the energies of a solid, for reports and for the check that none appears from nothing.
#pragma once

#include "flow/solid.hpp"

namespace rhexis {

class SolidEnergy {
public:
    explicit SolidEnergy(const SolidModel& model);

    /// 1/2 sum m v^2 with the inertia that the solvers use [nJ].
    double kinetic(const SolidModel& model, const SolidState& state);
    /// Corotational energy of what is left [nJ].
    double elastic(const SolidModel& model, const SolidState& state);
    /// Coarse tetrahedra with negative volume, of those with more than `least` of them left.
    int inverted(const SolidModel& model, const SolidState& state, double least);

private:
    void update(const SolidModel& model, const SolidState& state);

    ElementDomains domains_;
    std::vector<TetStiffness> stiffness_;
    GradientElements elements_;
    std::vector<double> inertia_;
};

}  // namespace rhexis
