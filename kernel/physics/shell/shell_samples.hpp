// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a shell's middle surface as contact meets it. Every triangle carries a cubic patch: its corners are
// the nodes, its tangents along the edges there those at rest, turned with the nodes,
//
//   b_iij = x_i + R_i (X_j - X_i) / 3,   b_123 = (sum of the six b_iij) / 4 - (sum of the three x_i) / 6
//
// (Bezier points; the last so that parabolas are exact [Vlachos2001]). Neighbours share the curves of their edges, and
// at rest the patch is the triangle. Any place is linear in positions and rotations of three nodes, p = sum weight x +
// R arm.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "flow/shell.hpp"

namespace rhexis {

/// A place of the surface, by its nodes.
struct ShellPlace {
    std::array<int, 3> nodes{-1, -1, -1};                                ///< -1: unused
    std::array<double, 3> weights{};                                     ///< sum 1
    std::array<Vec3, 3> arms{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< at rest, turned with its node [mm]
    std::array<double, 3> blend{};  ///< linear, sum 1: of the nodes' turns, for what lies across the thickness
    double thickness = 0.0;         ///< [mm]
};

/// Three places of the same nodes as one.
ShellPlace place_between(const std::array<ShellPlace, 3>& places, const std::array<double, 3>& share);

/// Every triangle cut in 4^level, evenly in its own coordinates.
struct ShellSamples {
    struct Sample {
        ShellPlace place;
        double area = 0.0;  ///< that it stands for, at rest [mm^2]
        double edge = 0.0;  ///< likewise of the edge's face: its length times thickness; 0: not on the edge [mm^2]
        int triangle = 0;   ///< one that it belongs to
    };
    std::vector<Sample> samples;             ///< nodes first, then others, each once; last what only the edge has
    std::vector<std::array<int, 3>> facets;  ///< by triangles, facets_each of each; indices of samples
    int facets_each = 1;
    /// The corners of a facet as places of its own triangle's nodes, in their order.
    std::vector<std::array<ShellPlace, 3>> corners;
};

/// level 0 to 4. edge_spacing: along the edge samples are at most so far apart, in thicknesses: what is thinner than
/// the shell and stands on its edge slips in between two of them otherwise.
ShellSamples shell_samples(const ShellModel& model, int level, double edge_spacing = HUGE_VAL);

}  // namespace rhexis
