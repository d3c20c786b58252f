// SPDX-License-Identifier: GPL-3.0-or-later
// A thin elastic or viscoelastic shell that moves and turns through any angle while it strains little, such as the
// foldable lens: what it is (model), what changes (state). Every node has six freedoms: three movements, then three
// turns about the axes of space.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/contact.hpp"
#include "flow/material.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

/// Freedoms of a node that the scene holds where they are.
struct ShellHold {
    int node = 0;
    std::array<bool, 6> held{true, true, true, true, true, true};  ///< movement x, y, z; turn about x, y, z
};

/// Beside the spring of the material's modulus a second one in series with a dashpot (standard linear solid, one
/// Maxwell branch): a strain that is held bears 1 + branch_share times the stress at first, and the branch's part of it
/// dies away as exp(-t / time). The strain of what is let go dies away with the longer (1 + branch_share) time.
/// Defaults are proposals, chosen for 5 to 20 s of unfolding at 23 C.
struct ShellRelaxation {
    double branch_share = 9.0;            ///< modulus of the branch over the material's, 0 to 1e4
    double time = 0.5;                    ///< of relaxation at the reference temperature [s], 1e-6 to 1e6
    double reference_temperature = 23.0;  ///< [C], -50 to 150
    double activation_energy = 1.2e5;     ///< [J/mol], 0 to 1e6: time by temperature as Arrhenius says
};

/// Constant while a scene runs.
struct ShellModel {
    std::string name;
    TriMesh mesh;                   ///< at rest: the middle surface, flat or curved [mm]
    std::vector<double> thickness;  ///< per triangle [mm], 1e-4 to 100
    Material material{"acrylic", 1.0e6, 0.42, 1.2e-3, 0.0, 0.0, Vec3::Zero()};
    double damping_mass = 0.0;                  ///< Rayleigh damping, share of the mass [1/s], 0 to 1e8
    double damping_stiffness = 0.0;             ///< Rayleigh damping, share of the stiffness [s], 0 to 10
    std::optional<ShellRelaxation> relaxation;  ///< none: elastic
    double temperature = 23.0;                  ///< of the shell [C], -50 to 150
    double fluid_density = 0.0;                 ///< of what it displaces [g/mm^3], 0 to 1
    double drag = 0.0;                          ///< of fluid at rest, per area and speed [g/(s mm^2)], 0 to 1e3
    double friction = 0.2;                      ///< Coulomb coefficient of its layers on each other, 0 to 10
    /// With which its layers, once pressed together, hold to each other: the pull per area that parts them [Pa], 0 to
    /// 1e6
    double tack = 0.0;
    double tack_range = 0.02;      ///< gap over which that falls to nothing [mm], 1e-4 to 0.1
    std::vector<ShellHold> holds;  ///< one per node at most, by ascending node
};

/// Numbers of a triangle's deformation: u, v, then three turns of each corner, in the triangle's own frame.
inline constexpr int shell_deformation_length = 15;

/// A force spread evenly over nodes, constant until changed by the caller.
struct ShellPull {
    std::vector<int> nodes;
    Vec3 total = Vec3::Zero();  ///< [uN]
};

/// A place of the surface that friction or jaws hold: what the next step must know of it.
struct ShellTouch {
    ContactPartner partner = ContactPartner::tool;
    int index = 0;                ///< of the partner
    int sample = 0;               ///< of the surface
    bool front = true;            ///< of another layer: it lies before the sample, else behind it
    Vec3 stretch = Vec3::Zero();  ///< from where it is held to where it is [mm]; tools, jaws, tubes: in their frame
};

/// Changes from step to step; by nodes unless said.
struct ShellState {
    std::vector<Vec3> position;  ///< [mm]
    std::vector<Quat> rotation;  ///< since rest, unit
    std::vector<Vec3> velocity;  ///< [mm/s]
    std::vector<Vec3> spin;      ///< angular velocity, in space [rad/s]
    /// Deformation of the branch's spring, 15 per triangle: zero where a strain has been held for long. Empty in an
    /// elastic shell.
    std::vector<double> branch;
    std::vector<ShellPull> loads;
    std::vector<ShellTouch> touches;  ///< ascending by partner, index, sample, front
    /// It lies in the cartridge of an injector that has not come into the eye: places are in the injector's frame, and
    /// it stays as it is.
    bool loaded = false;
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

/// Fails unless there is one of everything per node and, where it relaxes, a branch per triangle; finite, with unit
/// rotations and loads on nodes that there are.
Status check_shell_state(const ShellModel& model, const ShellState& state);

ShellState rest_state(const ShellModel& model);

/// As a rigid body, with all that it remembers of planes, tubes and bags.
ShellState moved(ShellState state, const Pose& by);

/// Leaves it where it is, without velocities.
void stop(ShellState& state);

/// At the model's temperature [s]; time exp(activation_energy / R (1 / T - 1 / T_reference)) [Arrhenius1889].
double relaxation_time(const ShellRelaxation& relaxation, double temperature);

/// Share of drag per area and speed [g/(s mm^2)] of a disc that moves broadside on in a fluid so viscous, or so slowly,
/// that inertia does not count: 16 viscosity radius speed in all [HappelBrenner1983]. Edge on it is two thirds of that,
/// which we leave at the same. viscosity [Pa s], radius [mm], above 0.
double disc_drag(double viscosity, double radius);

/// [g]
double shell_mass(const ShellModel& model);

}  // namespace rhexis
