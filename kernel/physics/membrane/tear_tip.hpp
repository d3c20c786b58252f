// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: whether a tear goes on, and which way.
//
// Which way: of the stress about the tip, weighted by (1 - r / tear_radius) and taken only ahead of it, the direction
// of opening u in which it is largest against the strength,
//   max over u of u.S u / u.A u,  A = s_along I + (s_across - s_along) f f^T,
// a generalised eigenvalue problem of 2x2 [Dequidt2013] eqs. 1 to 4 with the strength as a quadratic form. Strengths
// follow from toughness, s ~ sqrt(Gc) (Irwin), so only their ratio counts. The tear runs at a right angle to u, within
// a cone about the way it came.
//
// Whether: the energy that comes free per area, by the domain integral of the energy-momentum tensor [Eshelby1975],
// [LiShihNeedleman1985] over the sheet at rest,
//   G = 1/h sum over triangles of V (F^T P - w I) : (d x grad q),
// q falling from 1 at the tip to 0 away from it, and at other tips: what pulls those on is not this one's. It does not
// depend on the size of the triangles or of the domain.
#pragma once

#include <optional>
#include <vector>

#include "energy/membrane_triangle.hpp"
#include "flow/membrane.hpp"

namespace rhexis {

/// A triangle near a tip, which can be reached from it without crossing a tear.
struct NearTriangle {
    int triangle;
    double distance;  ///< of its middle at rest [mm]
};
std::vector<NearTriangle> near_tip(const MembraneSheet& sheet, int node, double radius);

/// Energy momentum at a tip: G of a direction d is d . release [uN/mm]; the part along the way the tear came is exact.
Vec3 release_at(const MembraneModel& model, const MembraneState& state, int node, double radius);

/// Stress about a tip and the plane in which it is given.
struct TipStress {
    PlaneFrame frame;            ///< of the sheet at rest there
    Mat2 stress = Mat2::Zero();  ///< weighted mean [Pa]
    Vec2 fibre = Vec2::Zero();   ///< unit
};
/// direction: the way that the tear came, or zero: all around.
TipStress stress_at(const MembraneModel& model, const MembraneState& state, int node, const Vec3& direction);

/// The direction of a tear, unit, in the plane: at a right angle to the opening that the stress overcomes first.
/// within: unit, or zero: any; cosine: of the widest angle from it. ratio: strength across the fibres over that along
/// them. Nothing where no direction within the cone is pulled open.
std::optional<Vec2> tear_direction(const Mat2& stress, const Vec2& fibre, double ratio, const Vec2& within,
                                   double cosine);

/// One proposal per tip at which the energy suffices, but for tips that a needle pushes: see propose_cuts().
std::vector<TearProposal> propose_tears(const MembraneModel& model, const MembraneState& state);

}  // namespace rhexis
