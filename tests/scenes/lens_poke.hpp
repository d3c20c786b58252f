// SPDX-License-Identifier: GPL-3.0-or-later
// The load case that accuracy is judged by: the default patient's lens, its posterior surface held, pressed at the
// anterior pole by a smooth pressure. Mesh-free: every mesh and every kind of element sees the same load.
#pragma once

#include <vector>

#include "flow/solid.hpp"

namespace rhexis::scenes {

/// Pressure p(r) = p0 (1 - (r / radius)^2)^2 toward -z on the anterior surface, r the distance from the axis [mm].
struct PokeLoad {
    double radius = 1.5;       ///< [mm]
    double total = 1000.0;     ///< [uN]
    double held_below = -0.3;  ///< surface nodes with z below this are held [mm]
};

struct LensPoke {
    PokeLoad load;
    SolidModel lens;               ///< fixed_nodes: the held ones
    std::vector<Vec3> nodal_load;  ///< per coarse node [uN]; sums to (0, 0, -total)
};

/// The default patient's lens with about that many tetrahedra.
LensPoke lens_poke(int tetrahedra, const PokeLoad& load = {});

/// The pressure of the load at a point, in units of p0.
double poke_pressure(const PokeLoad& load, const Vec3& point);

/// What the tool at the pole feels as displacement: sum f . u / |sum f| [mm], positive along the load.
double poke_depth(const LensPoke& poke, const std::vector<Vec3>& position);

/// Depth per load of the linear problem, by a direct solver [mm/uN].
double linear_compliance(const LensPoke& poke, Formulation formulation);
/// The same for elements of one's own, all of which bear load.
double linear_compliance(const LensPoke& poke, const std::vector<GradientElements>& elements);

}  // namespace rhexis::scenes
