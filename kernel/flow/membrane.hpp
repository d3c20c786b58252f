// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet that stretches, wrinkles and tears: what it is (model), what changes (state). Its connectivity is a
// value of its own, because it changes while a scene runs: a sheet is never altered, a tear makes the next one, and so
// does an instrument that takes a piece of it out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "energy/orthotropic.hpp"
#include "flow/bag.hpp"
#include "flow/contact.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

/// Connectivity and what each triangle is made of. Only topology makes new ones; nodes keep their numbers, and those
/// that a tear adds come at the end. Nodes of what was taken out belong to no triangle: they move no more and meet
/// nothing.
struct MembraneSheet {
    TriMesh mesh;                   ///< at rest [mm]
    TriNeighbours neighbours;       ///< of the mesh
    std::vector<int> origin;        ///< per node: that of the model's sheet of which it is a copy; -1: none, on an edge
    std::vector<Vec3> fibre;        ///< per triangle: unit, in its plane at rest
    std::vector<double> thickness;  ///< per triangle [mm]
    std::vector<double> stiffness;  ///< per triangle: factor on the material's moduli
};

/// Energy that a tear takes per area that it opens [uN/mm], that is mJ/m^2. Running at an angle a to the fibres it
/// takes
///   along + (across - along) sin^2 a.
struct Toughness {
    double along = 1.0e6;
    double across = 1.0e6;
};

/// Holds a node elastically to a fixed place. Copies of the node that a tear makes share it.
struct NodeSpring {
    int node = 0;
    Vec3 anchor = Vec3::Zero();  ///< [mm]
    double stiffness = 0.0;      ///< [uN/mm]
    double slack = 0.0;          ///< length below which it does not pull [mm]
    bool on_support = false;     ///< the place goes with the support, which feels the spring along z
};

/// A smooth rigid body that a membrane lies on: the lens under its capsule. It stays where it is, or moves along z.
struct SupportModel {
    BagShape shape;           ///< where it rests, in the eye's frame
    double friction = 0.05;   ///< Coulomb coefficient
    double stiffness = 0.0;   ///< of what holds it along z besides the membrane [uN/mm]; 0: it does not move
    double slack_lift = 0.0;  ///< at which that neither pushes nor pulls [mm]
    double damping = 0.0;     ///< of that motion [uN s/mm]; > 0 where it moves
};

struct SupportState {
    double lift = 0.0;  ///< along z, from where it rests [mm]
    double push = 0.0;  ///< along z, from behind [uN]
};

/// Constant while a scene runs.
struct MembraneModel {
    std::string name;
    std::shared_ptr<const MembraneSheet> sheet;  ///< at the start
    Orthotropic material;
    Toughness toughness;
    double tear_radius = 0.4;        ///< about the tip of a tear, of what decides on its way [mm]
    double turn_cosine = 0.0;        ///< of the sharpest turn of a tear from the way it came
    double piercing = 1.0e12;        ///< force of a needle's end per thickness at which it goes through [uN/mm]
    double density = 1.05e-3;        ///< [g/mm^3]
    double buoyancy_density = 0.0;   ///< of the fluid around it [g/mm^3]; gravity acts on the difference
    double damping_mass = 0.0;       ///< Rayleigh damping, share of the mass [1/s]
    double damping_stiffness = 0.0;  ///< Rayleigh damping, share of the stiffness [s]
    double slack_share = 1e-3;       ///< of its stiffness that is left in compression
    std::vector<int> fixed_nodes;    ///< move only by hand of the caller, with their copies; ascending
    std::vector<NodeSpring> springs;
    std::optional<SupportModel> support;
    /// What is folded over keeps it from what is below [mm], 0 to 0.1; 0: they pass through each other, as they must
    /// where there is no support.
    double layer_distance = 0.0;
    double shell_friction = 0.1;  ///< Coulomb coefficient, on a shell that lies in it, 0 to 10
    /// Of its edges, length over that at rest, at which they give way, 1.01 to 100; 0: they do not.
    double rupture_stretch = 0.0;
};

/// The end of a tear, which may go on.
struct TearTip {
    int node = 0;
    Vec3 direction = Vec3::Zero();  ///< the way it came: unit, in the sheet's plane at rest
    Vec3 owed = Vec3::Zero();       ///< from the node, where the mesh allowed it to go, to where it ought to be [mm]
};

/// What a contact is known by from step to step. With both a triangle and a node it is one of the sheet with itself:
/// the node is above the triangle.
struct SheetTouch {
    int triangle = -1;  ///< that touches; -1: the node does
    int node = -1;
    ContactPartner partner = ContactPartner::tool;
    int index = 0;
    Vec3 stretch = Vec3::Zero();  ///< from where friction holds it to where it is, in the partner's frame [mm]
};

/// A node that the jaws of an instrument hold, or that a needle pushes before it.
struct SheetGrip {
    int tool = 0;
    int node = 0;
    Vec3 place = Vec3::Zero();  ///< where they hold it, in the tool's frame [mm]
    bool pushed = false;        ///< by a needle, across it only: it slides along it
    double slack = 0.0;         ///< how far a needle goes before it pushes [mm]
};

/// What physics proposes: a needle goes through.
struct PunctureProposal {
    int triangle = 0;
    Vec3 place = Vec3::Zero();      ///< of it at rest [mm]
    Vec3 direction = Vec3::Zero();  ///< of the slit that its edge cuts, in the sheet at rest
};

/// What physics proposes: a needle that stands in a tear cuts on.
struct CutProposal {
    int tool = 0;
    int node = 0;                   ///< on the lip, from which the cut goes
    Vec3 direction = Vec3::Zero();  ///< in the sheet at rest
};

/// What physics proposes: an edge of the sheet gives way.
struct NotchProposal {
    int node = 0;
    Vec3 direction = Vec3::Zero();  ///< of the tear that begins there: unit, in the sheet at rest
};

/// What physics proposes: the tear goes on from a tip, because more energy comes free than it takes.
struct TearProposal {
    int tip = 0;                    ///< index into the state's tips
    Vec3 direction = Vec3::Zero();  ///< unit, in the sheet's plane at rest
    double release = 0.0;           ///< energy that comes free per area [uN/mm]
    double toughness = 0.0;         ///< that it takes in this direction [uN/mm]
};

/// A force spread evenly over nodes of a sheet, constant until changed by the caller.
struct SheetLoad {
    std::vector<int> nodes;
    Vec3 total = Vec3::Zero();  ///< [uN]
};

/// Changes from step to step.
struct MembraneState {
    std::shared_ptr<const MembraneSheet> sheet;
    std::vector<Vec3> position;  ///< [mm]
    std::vector<Vec3> velocity;  ///< [mm/s]
    std::vector<TearTip> tips;   ///< those that went on last at the end
    std::vector<SheetLoad> loads;
    std::vector<SheetTouch> touches;  ///< in the order in which they were found
    std::vector<SheetGrip> grips;     ///< by tools
    SupportState support;
    std::vector<Vec3> punctures;  ///< where needles went through, in the sheet at rest [mm]
    double torn_area = 0.0;       ///< that tears have opened so far: length times thickness [mm^2]
    double torn_energy = 0.0;     ///< that they took [nJ]
    double edge_out = 0.0;        ///< length at rest of the edges of what instruments took out [mm]
    double area_out = 0.0;        ///< its area at rest [mm^2]
};

/// Fibres all one way and the same thickness everywhere. fibre: need not lie in the sheet; not at a right angle to it.
MembraneSheet uniform_sheet(TriMesh mesh, const Vec3& fibre, double thickness);

/// Fails with the field, the number of the triangle or node, and what is allowed.
Status check_membrane(const MembraneModel& model, UnusedNodes unused = UnusedNodes::refused);

MembraneState rest_state(const MembraneModel& model);

/// So many times its greater modulus times its mean thickness [uN/mm].
double stretch_stiffness(const MembraneModel& model, const MembraneSheet& sheet, double times);

/// Whether a node belongs to what was taken out.
bool is_out(const MembraneSheet& sheet, int node);

/// Whether a node moves only by hand of the caller, or not at all since it is out.
bool is_fixed(const MembraneModel& model, const MembraneSheet& sheet, int node);

/// Unit vector to the front of a triangle at rest.
Vec3 front_of(const TriMesh& mesh, int triangle);

/// Whether a triangle is folded over: its front looks against where it looked at rest.
bool folded(const MembraneState& state, int triangle);

/// Energy per area of a tear that runs along a direction in a triangle [uN/mm].
double toughness_along(const Toughness& toughness, const Vec3& fibre, const Vec3& direction);

}  // namespace rhexis
