// SPDX-License-Identifier: GPL-3.0-or-later
// A deformable solid: what it is (model) and what changes (state). Solvers keep their own caches of the model.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "energy/gradient_elements.hpp"
#include "flow/material.hpp"
#include "flow/mesh_edit.hpp"
#include "mesh/tet_mesh.hpp"

namespace rhexis {

inline constexpr double least_fraction = 0.01;  ///< less of a fine tetrahedron drifts away and counts as removed
inline constexpr double still_there = 0.3;      ///< of a fine tetrahedron: one with less left is not drawn

/// What is left of each material point of a fine tetrahedron (mesh/material_points.hpp), 1 down to 0.
struct PartlySpent {
    int fine = 0;
    std::array<double, 4> left{1.0, 1.0, 1.0, 1.0};
};

/// Way to advance a solid in time.
enum class Advance {
    automatic,  ///< explicit where the stable step makes it the cheaper way, else implicit
    explicit_,  ///< symplectic Euler substeps in float, [numerics: corotational linear tetrahedra]
    implicit,   ///< backward Euler of the same model in double
};

/// Constant while a scene runs.
struct SolidModel {
    std::string name;                 ///< "lens", "bar", ...
    TetMesh coarse;                   ///< mechanics
    FineMesh fine;                    ///< contact, sculpting and picture; empty if the body needs none of them
    std::vector<Material> materials;  ///< indexed by coarse.region
    std::vector<int> fixed_nodes;     ///< coarse nodes that never move, ascending
    double damping_mass = 0.0;        ///< Rayleigh damping, share of the mass [1/s]
    double damping_stiffness = 0.0;   ///< Rayleigh damping, share of the stiffness [s]
    double buoyancy_density = 0.0;    ///< density of the fluid around it [g/mm^3]; gravity acts on the difference
    double stiffness_floor = 0.02;    ///< smallest factor on the stiffness of a tetrahedron that is still there
    double sought_step = 0.0;         ///< explicit: nodes that are too light for it get more inertia, not weight [s]
    Advance advance = Advance::automatic;
    Formulation formulation = Formulation::linear;
    bool by_points = false;  ///< tools meet its material points, and ultrasound takes each by itself; else its vertices
};

/// Changes from step to step.
struct SolidState {
    std::vector<Vec3> position;  ///< coarse nodes [mm]
    std::vector<Vec3> velocity;  ///< coarse nodes [mm/s]
    std::vector<double>
        fraction;  ///< remaining share of each fine tetrahedron, 1 down to 0 (gone); empty if no fine mesh
    std::vector<PartlySpent> spent;  ///< ascending; of a fine tetrahedron that is not here each point has its fraction
    std::vector<std::uint8_t> present;  ///< per coarse tetrahedron: 1, or 0 once removed from mechanics
    std::vector<BrokenFace> broken;     ///< faces that have given way, ascending
    std::vector<NodeSplit> splits;      ///< made since the start, in order; the model has their nodes
};

/// The state at rest, everything present.
SolidState rest_state(const SolidModel& model);

/// Of the four material points of a fine tetrahedron.
std::array<double, 4> left_of_points(const SolidState& state, int fine);

/// Takes away from a fine tetrahedron what leaves `fraction` of it, from each point its part.
void set_fraction(SolidState& state, int fine, double fraction);

/// Sets what is left of the points of a fine tetrahedron that is there, and by it its fraction.
void set_points(SolidState& state, int fine, const std::array<double, 4>& left);

/// Share of coarse tetrahedron t that is left: the mean of its 8 children, or `present` without a fine mesh.
double remaining_fraction(const SolidModel& model, const SolidState& state, int t);

/// Mass of coarse tetrahedron t when whole [g].
double tet_mass(const SolidModel& model, int t);

/// Mass of all that is left [g].
double remaining_mass(const SolidModel& model, const SolidState& state);

}  // namespace rhexis
