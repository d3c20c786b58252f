// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that moves in a scene: the constant model and the state of one step.
#pragma once

#include <optional>
#include <vector>

#include "flow/bag.hpp"
#include "flow/beads.hpp"
#include "flow/capsule.hpp"
#include "flow/chamber.hpp"
#include "flow/contact.hpp"
#include "flow/cortex.hpp"
#include "flow/debris.hpp"
#include "flow/globe.hpp"
#include "flow/hydrodissection.hpp"
#include "flow/implant_parts.hpp"
#include "flow/iris.hpp"
#include "flow/lids.hpp"
#include "flow/membrane.hpp"
#include "flow/microscope.hpp"
#include "flow/prolapse.hpp"
#include "flow/retained_viscoelastic.hpp"
#include "flow/shell.hpp"
#include "flow/solid.hpp"
#include "flow/tool.hpp"
#include "flow/viscoelastic.hpp"
#include "flow/vitreous.hpp"
#include "flow/wounds.hpp"

namespace rhexis {

/// A fixed half-space that solids rest on.
struct PlaneModel {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< unit, into the free side
    double friction = 0.3;
};

/// The inner wall of the eye's front part: what comes loose stays inside this ball.
struct DomeModel {
    Vec3 centre = Vec3::Zero();
    double radius = 6.45;  ///< [mm]
    double friction = 0.1;
};

/// A force spread over nodes of a solid, constant until changed by the caller.
struct NodeLoad {
    int solid = 0;
    std::vector<int> nodes;
    Vec3 total = Vec3::Zero();  ///< [uN]
};

struct WorldModel {
    std::vector<SolidModel> solids;
    std::vector<MembraneModel> membranes;
    std::vector<ShellModel> shells;
    std::optional<ImplantParts> implant;  ///< of shells[0]
    std::vector<BagModel> bags;
    std::vector<PlaneModel> planes;
    std::vector<DomeModel> domes;
    std::vector<ToolModel> tools;
    std::optional<ChamberModel> chamber;
    std::optional<CapsuleModel> capsule;  ///< the posterior wall of bags[0]
    std::optional<IrisModel> iris;
    std::optional<ViscoelasticModel> viscoelastic;        ///< in place of a chamber through which fluid flows
    std::optional<VitreousModel> vitreous;                ///< behind bags[0], whose wall has a capsule, and a chamber
    std::optional<WoundsModel> wounds;                    ///< in place of the constant leak of the chamber
    std::optional<GlobeModel> globe;                      ///< rolls under shafts; else it stands still
    std::optional<ProlapseModel> prolapse;                ///< of an iris into the main one of simulated wounds
    std::optional<HydrodissectionModel> hydrodissection;  ///< of solids[0] in bags[0]; with capsule and chamber
    std::optional<CortexModel> cortex;                    ///< on the wall of bags[0]; with capsule and chamber
    std::optional<RetainedViscoelasticModel> retained;    ///< with bags[0] and chamber
    std::optional<MicroscopeModel> microscope;
    std::optional<LidsModel> lids;
    std::optional<BeadsModel> beads;
    Vec3 gravity = Vec3(0.0, 0.0, -9810.0);  ///< [mm/s^2]; the patient lies on the back, anterior is +z
};

/// How a resting contact stuck: the anchor that friction remembers. State, because it must survive a snapshot.
struct ContactMemory {
    int solid = 0;
    int vertex = 0;  ///< fine (or coarse) surface vertex
    ContactPartner partner = ContactPartner::tool;
    int partner_index = 0;
    Vec3 anchor = Vec3::Zero();  ///< in the partner's frame [mm]
    Vec3 force = Vec3::Zero();   ///< last force, for warm starting [uN]
};

struct WorldState {
    std::vector<SolidState> solids;
    std::vector<MembraneState> membranes;
    std::vector<ShellState> shells;
    std::vector<BagState> bags;
    std::optional<ChamberState> chamber;
    ChamberFlows flows;  ///< of the last step
    std::optional<CapsuleState> capsule;
    std::optional<IrisState> iris;
    std::optional<ViscoelasticState> viscoelastic;
    std::optional<VitreousState> vitreous;
    std::optional<WoundsState> wounds;
    std::optional<GlobeState> globe;
    std::optional<ProlapseState> prolapse;
    std::optional<HydrodissectionState> hydrodissection;
    std::optional<CortexState> cortex;
    std::optional<RetainedViscoelasticState> retained;
    std::optional<MicroscopeState> microscope;
    std::optional<LidsState> lids;
    std::optional<BeadsState> beads;
    std::vector<TipState> tips;          ///< per tool
    std::vector<PlungerState> plungers;  ///< per tool
    std::vector<Debris> debris;
    std::vector<NodeLoad> loads;
    std::vector<ContactMemory> memory;  ///< ordered by (solid, vertex, partner, partner_index)
    double removed_mass = 0.0;          ///< mass emulsified or aspirated so far [g]
    double ablation_energy = 0.0;       ///< ultrasound energy spent in tissue so far [mJ]
    double time_s = 0.0;
};

/// The state at rest of everything in the model.
WorldState rest_state(const WorldModel& model);

/// From where most of the vitreous in front has come: the middle of the hole in the capsule, or the edge of the bag
/// where zonules are lost [mm]. The scene has a capsule and vitreous.
Vec3 vitreous_place(const WorldModel& model, const std::vector<BagState>& bags, const CapsuleState& capsule,
                    const VitreousState& vitreous);

}  // namespace rhexis
