// SPDX-License-Identifier: GPL-3.0-or-later
// tools -> physics, observe, render: instruments as kinematic rigid bodies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flow/tube.hpp"
#include "math/types.hpp"

namespace rhexis {

/// probe: a blunt rod or ball that only pushes; cystotome: a needle that pierces a membrane; forceps: jaws that hold
/// one, or an implant; cannula: what the hand presses out of its syringe comes out of its end; injector: its plunger
/// pushes an implant out of a cartridge; cutter: a mouth that sucks, and a blade that cuts what is in it; blade: it
/// cuts its way into the eye; hydrator: a cannula with saline; needle: it carries a suture; sponge: it presses from
/// outside; capsule_hook: stays on the edge of the capsule's opening when the hand lets go of it there; ring: is fed
/// into the bag; aspirator: a mouth in its side that sucks; drape: covers lashes; speculum: opens
/// lids.
enum class ToolKind {
    probe,
    phaco,
    cystotome,
    forceps,
    cannula,
    injector,
    cutter,
    blade,
    hydrator,
    needle,
    sponge,
    capsule_hook,
    ring,
    aspirator,
    drape,
    speculum
};

/// Cuts per minute of a cutter at its fastest.
inline constexpr double fastest_cutter = 5000.0;

/// Opening from which on the jaws of forceps are closed, 0 to 1.
inline constexpr double closed_jaw = 0.25;

/// A cone with round ends, in the tool's frame; equal ends make a ball.
struct RoundedCone {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
    double radius_a = 0.1;  ///< [mm]
    double radius_b = 0.1;  ///< [mm]
};

/// Of an injector.
struct Cartridge {
    TubeModel bore;               ///< in the tool's frame; its last station is the tip
    double loaded_at = 0.0;       ///< along the bore: where the middle of the implant is laid [mm]
    double room = 0.0;            ///< length that it may take there [mm]
    double plunger_radius = 0.0;  ///< a rod with a round end on the bore's axis [mm]
    double plunger_from = 0.0;    ///< along the bore: the tip of the plunger before it is pushed [mm]
    double stroke = 0.0;          ///< how far it can be pushed [mm]
    double most_force = 0.0;      ///< with which a hand can push it [uN]
    double fastest = 0.0;         ///< that a hand can push it [mm/s]
};

/// Constant while a scene runs.
struct ToolModel {
    std::string name;  ///< "phaco", "probe", ...
    ToolKind kind = ToolKind::probe;
    std::vector<RoundedCone> parts;  ///< union; parts[0] is the working end
    double friction = 0.2;           ///< Coulomb coefficient against tissue
    double bore_radius = 0.0;        ///< phaco: inner radius of the tip [mm]
    double edge_radius = 0.0;        ///< roundness of its sharpest edge [mm]; 0: that of its end
    double bevel = 0.0;              ///< phaco: angle of the opening from square [rad]
    double cutting = 1.0;            ///< cystotome: share of its toughness that a sheet has at the end of a cut
    double reach = 0.0;        ///< forceps: radius of the ball about the tip in which its jaws close on a membrane [mm]
    double lens_reach = 0.0;   ///< likewise of those that close on an implant [mm]
    double hold = 0.0;         ///< forceps, cystotome: most that jaws or hook bear before it slips [uN]
    double max_power = 0.0;    ///< phaco: ultrasound power delivered to tissue at 100 % [mW]
    double blade_width = 0.0;  ///< blade: beyond its point [mm]
    double blade_point = 0.0;  ///< blade: length of its point, over which it widens [mm]
    bool stains = false;       ///< cannula: what comes out of it is triamcinolone, not viscoelastic
    bool saline = false;       ///< cannula: what comes out of it is saline
    std::optional<Cartridge> cartridge;
};

/// What stands before the open mouth of an aspirating tip, and what it does to it.
struct TipState {
    double lens = 0.0;  ///< share of the mouth that each covers, 0 to 1
    double capsule = 0.0;
    double iris = 0.0;
    double debris = 0.0;
    double open = 1.0;     ///< share of the free tip's conductance
    double suction = 0.0;  ///< pressure in the eye above that in the tip [Pa]
    double flow = 0.0;     ///< into the tip [mm^3/s]
    double hold = 0.0;     ///< with which the covering tissue is held on [uN]
};

/// Where the plunger of an injector is, which is not where the hand wants it when that takes too much force.
struct PlungerState {
    double pushed = 0.0;     ///< from where it stands before it is pushed [mm]
    double force = 0.0;      ///< with which it presses on the implant, along the bore [uN]
    double stiffness = 0.0;  ///< growth of the force with its way, of late [uN/mm]
};

/// One step of one tool. Poses within the step are interpolated from previous_pose to pose.
struct ToolState {
    bool present = false;
    Pose pose;
    Pose previous_pose;            ///< at the end of the previous step; equal to pose on the step in which it appears
    Vec3 velocity = Vec3::Zero();  ///< of the tip [mm/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
    double jaw = 0.0;                      ///< opening, 0 closed to 1 open; cannula: how hard the hand presses, 0 to 1;
                                           ///< injector: how far the hand wants the plunger, share of its stroke;
                                           ///< capsule_hook: 1 held; ring: how far the hand has fed it
    double previous_jaw = 0.0;             ///< at the end of the previous step
    double pedal = 0.0;                    ///< 0 to 3
    bool irrigation = false;               ///< pedal at 1 or more
    double aspiration = 0.0;               ///< share of the set vacuum, 0 to 1 (pedal 2)
    double power = 0.0;          ///< share of full ultrasound power, 0 to 1 (pedal 3); mean over the step when pulsed;
                                 ///< cutter: cuts per time, share of fastest_cutter
    double ultrasound_s = 0.0;   ///< since the pedal went down to position 3: where a train of pulses is [s]
    double bottle_height = 0.0;  ///< phaco: drip chamber above the eye [mm]
    double pump_flow = 0.0;      ///< phaco: what the pedal asks of the pump [mm^3/s]
    double vacuum_limit = 0.0;   ///< phaco: what the pedal allows it [Pa]
};

/// The open end of an aspirating tip, in the tool's frame.
struct Mouth {
    Vec3 centre = Vec3::Zero();    ///< [mm]
    Vec3 facing = -Vec3::UnitZ();  ///< unit, outward
};
Mouth tip_mouth(const ToolModel& tool);

}  // namespace rhexis
