// SPDX-License-Identifier: GPL-3.0-or-later
// A thin elastic shell that moves and turns through any angle while it strains little, such as the foldable lens: what
// it is (model), what changes (state). Every node has six freedoms: three movements, then three turns about the axes of
// space.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/material.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

/// Freedoms of a node that the scene holds where they are.
struct ShellHold {
    int node = 0;
    std::array<bool, 6> held{true, true, true, true, true, true};  ///< movement x, y, z; turn about x, y, z
};

/// Constant while a scene runs.
struct ShellModel {
    std::string name;
    TriMesh mesh;                   ///< at rest: the middle surface, flat or curved [mm]
    std::vector<double> thickness;  ///< per triangle [mm], 1e-4 to 100
    Material material{"acrylic", 1.0e6, 0.42, 1.2e-3, 0.0, 0.0, Vec3::Zero()};
    double damping_mass = 0.0;       ///< Rayleigh damping, share of the mass [1/s], 0 to 1e8
    double damping_stiffness = 0.0;  ///< Rayleigh damping, share of the stiffness [s], 0 to 10
    std::vector<ShellHold> holds;    ///< one per node at most, by ascending node
};

/// Changes from step to step; everything by nodes.
struct ShellState {
    std::vector<Vec3> position;  ///< [mm]
    std::vector<Quat> rotation;  ///< since rest, unit
    std::vector<Vec3> velocity;  ///< [mm/s]
    std::vector<Vec3> spin;      ///< angular velocity, in space [rad/s]
};

/// Forces and moments that keep their direction in space; either list by nodes, or empty. Such moments have no
/// potential, which costs Newton's method its last quick steps: the tangent stays symmetric.
struct ShellLoad {
    std::vector<Vec3> force;   ///< [uN]
    std::vector<Vec3> moment;  ///< [uN mm]
};

/// Every triangle of one thickness [mm].
ShellModel uniform_shell(std::string name, TriMesh mesh, double thickness);

/// Fails with the field, the number of the triangle or node, and what is allowed.
Status check_shell(const ShellModel& model);

/// Fails unless there is one of everything per node, finite, with unit rotations.
Status check_shell_state(const ShellModel& model, const ShellState& state);

ShellState rest_state(const ShellModel& model);

/// [g]
double shell_mass(const ShellModel& model);

}  // namespace rhexis
