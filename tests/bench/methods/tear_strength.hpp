// SPDX-License-Identifier: GPL-3.0-or-later
// The strength criterion of [Dequidt2013] eqs. 1 to 4, as corrected: it lost the chart of bench tear_load, because the
// stress in the triangles at a tip grows without end as they get smaller.
#pragma once

#include "physics/membrane/tear_tip.hpp"

namespace rhexis::bench {

struct Strength {
    double along = 1.0e6;   ///< against opening along the fibre [Pa]
    double across = 1.0e6;  ///< against opening across it: a tear along the fibre needs this [Pa]
    double alpha = 1.0;     ///< steepness of the blend between them
};

/// Strength against opening along u (unit); fibre: unit [Pa].
double strength_against(const Strength& strength, const Vec2& fibre, const Vec2& u);

struct StrengthAnswer {
    double ratio = 0.0;             ///< stress over strength, of the best direction: above 1 it tears
    Vec2 direction = Vec2::Zero();  ///< of the tear
};

/// The best of all directions within the cone about `within` (zero: any), by trying each 0.05 degrees.
StrengthAnswer search_directions(const Mat2& stress, const Strength& strength, const Vec2& fibre, const Vec2& within,
                                 double cosine);

/// Mean stress of the triangles at a tip that lie ahead of it.
TipStress one_ring_stress(const MembraneModel& model, const MembraneState& state, const TearTip& tip);

}  // namespace rhexis::bench
