// SPDX-License-Identifier: GPL-3.0-or-later
// The globe under the shafts that stand in its wounds: a shaft that leaves the middle of its wound bends the cornea
// there and rolls the globe in its orbit. Everything else is simulated in the eye's frame, which rolls with it; the
// room is where hands and microscope are. Formulas, sources and limits: docs/globe.md.
#pragma once

#include <array>
#include <cstddef>

#include "math/types.hpp"

namespace rhexis {

/// Wounds through which shafts turn the globe: main wound and side port.
inline constexpr std::size_t lip_count = 2;

/// Constant while a scene runs.
struct GlobeModel {
    Vec3 centre = Vec3::Zero();    ///< about which it rolls [mm]
    double stiffness = 3.37e6;     ///< of the orbit, torque per angle [uN mm/rad]: 0.6 g cm per degree [Simonsz1984]
    double lag = 0.1;              ///< with which it follows [s]. Proposal
    double lip_stiffness = 4.0e4;  ///< of the cornea beside a wound [uN/mm]. Proposal
    double bears = 0.25;           ///< deflection of a lip that leaves nothing [mm]. Proposal
    double stays = 0.5;            ///< share of what is beyond that stays as width of the wound. Proposal
    double most = 0.5;             ///< roll at which the orbit lets it go no further [rad]. Proposal
    Vec3 front_centre = Vec3::Zero();        ///< of the ball of the cornea's front [mm]
    double front_radius = 7.63;              ///< [mm]
    double opens = 0.1;                      ///< deflection of a lip from which its wound gapes [mm]. Proposal
    double opening = 1.0;                    ///< share of the deflection beyond, as height of the slit. Proposal
    double widest = 0.12;                    ///< height of that slit at most [mm]. Proposal
    double viscosity = 0.72e-3;              ///< of the fluid [Pa s]: water at 34 degrees
    double tunnel = 1.5;                     ///< of a wound that is not simulated itself [mm]. Proposal
    std::array<Vec3, lip_count> lips{};      ///< inner lips of main wound and side port [mm]
    std::array<double, lip_count> widths{};  ///< [mm]; 0: there is no such wound
};

/// One wound under its shaft.
struct Lip {
    double excursion = 0.0;          ///< of the shaft off where the wound is at rest, in the room [mm]
    Vec3 deflection = Vec3::Zero();  ///< of the cornea, in the eye's frame [mm]
    double enlargement = 0.0;        ///< of the wound, which stays [mm]
};

/// Changes from step to step.
struct GlobeState {
    Vec3 roll = Vec3::Zero();  ///< from the room to the eye: axis times twice the tangent of half the angle
    std::array<Lip, lip_count> lips{};
};

/// Rotation that takes the eye at rest to the eye as it is.
Quat rotation_of(const GlobeState& state);

/// How far it has rolled [rad].
double roll_angle(const GlobeState& state);

/// A place or a pose of the eye's frame in the room, and back.
Vec3 to_room(const GlobeModel& model, const GlobeState& state, const Vec3& place);
Pose to_room(const GlobeModel& model, const GlobeState& state, const Pose& pose);
Vec3 to_eye(const GlobeModel& model, const GlobeState& state, const Vec3& place);
Pose to_eye(const GlobeModel& model, const GlobeState& state, const Pose& pose);

/// What a wound lets through because a shaft presses on its lip, which then fits no more [mm^3/(s Pa)]. tunnel: length
/// of the wound [mm].
double pressed_conductance(const GlobeModel& model, const Lip& lip, double width, double tunnel);

}  // namespace rhexis
