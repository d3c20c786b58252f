// SPDX-License-Identifier: GPL-3.0-or-later
// The wounds of the eye: how a blade made them, what they leak, and what holds them shut. Formulas, sources and limits:
// docs/wounds.md.
#pragma once

#include <array>
#include <cstddef>

#include "flow/chamber.hpp"
#include "math/types.hpp"

namespace rhexis {

/// old_wound: the main wound that was left for a new one.
enum WoundPlace : std::size_t { main_wound, side_port, old_wound, wound_count };

/// One wound. The lips are points of the front and of the back of the cornea.
struct Wound {
    bool begun = false;           ///< a blade has entered the front of the cornea
    bool cut = false;             ///< and has come out of its back
    Vec3 outer = Vec3::Zero();    ///< middle of the outer lip [mm]
    Vec3 inner = Vec3::Zero();    ///< of the inner lip [mm]
    Vec3 mark = Vec3::Zero();     ///< last place of the blade's way that its direction was looked at [mm]
    Vec3 heading = Vec3::Zero();  ///< of the way before that, unit; zero: none yet
    double tunnel = 0.0;          ///< length of the way through the stroma [mm]
    int planes = 0;               ///< 1 and the changes of direction of that way
    double width = 0.0;           ///< of what is cut through [mm]
    double passed = 0.0;          ///< farthest that the blade has come out of the back [mm]
    double left = 0.0;            ///< farthest that its axis moved sideways at the outer lip, 0 or less [mm]
    double right = 0.0;           ///< 0 or more [mm]
    double peel = 0.0;            ///< length of Descemet's membrane that hangs off at the inner lip [mm]
    double most_peel = 0.0;       ///< the most so far [mm]
    double swelling = 0.0;        ///< of the stroma beside it: 0 none, 1 white and tight
    int sutures = 0;              ///< stitches that hold it
    double distortion = 0.0;      ///< of the cornea by its stitches, in dioptres of astigmatism
    double gape = 0.0;            ///< how far it stands open now, share of a wound without any tunnel; 0: shut
    double press = 0.0;           ///< force on its outer lip from outside now [uN]
    double leak = 0.0;            ///< through it now [mm^3/s]
    double fluid = 0.0;           ///< that lies on its outer lip [mm^3]
};

/// Constant while a scene runs. Those without a source are proposals.
struct WoundsModel {
    Vec3 front_centre = Vec3::Zero();  ///< of the ball that the front of the cornea is a part of [mm]
    double front_radius = 7.63;        ///< [mm]
    Vec3 back_centre = Vec3::Zero();   ///< likewise of its back [mm]
    double back_radius = 6.45;         ///< [mm]
    double limbus_radius = 5.82;       ///< [mm]
    double iris_z = 0.0;               ///< front of the iris at rest [mm]
    double pupil_radius = 3.75;        ///< at rest [mm]
    double lens_radius = 4.8;          ///< of the lens's front half [mm]
    double lens_front = 1.9;           ///< and its height [mm]

    double seal_ratio = 0.7;      ///< tunnel length per width that shuts a wound by itself: near square [Ernest1994]
    double one_plane = 0.85;      ///< what a tunnel of one plane counts for beside one that bends
    double valve = 0.15;          ///< by which 20 mmHg press a tunnel shut, per ratio beyond half of seal_ratio
    double widest_slit = 0.06;    ///< height of the slit of a wound that gapes fully [mm]
    double viscosity = 0.72e-3;   ///< of the fluid [Pa s]: water at 34 degrees
    double swelling_seals = 0.6;  ///< of the gape that full swelling closes
    double suture_closes = 0.5;   ///< that a stitch closes
    double burn_gapes = 1.0;      ///< that a full burn opens
    double burn_stiffens = 0.7;   ///< share of what swelling closes that a full burn prevents
    double press_gapes = 0.35;    ///< that 0.28 N on the outer lip open [Masket2014]
    double tight = 2.4;           ///< width of a wound that the instruments of the main wound fit [mm]

    double injection = 40.0;                        ///< of a syringe pressed with full force into the chamber [mm^3/s]
    double most_pressure = 80.0 * pascal_per_mmhg;  ///< of the eye against which a hand can press [Pa]
    double hydration = 0.5;          ///< swelling by a syringe pressed with full force into the stroma [1/s]
    double beside = 1.2;             ///< of a tunnel: stroma that belongs to it [mm]
    double swelling_lasts = 1800.0;  ///< [s]
    double skin_stiffness = 3.0e5;   ///< of the cornea near the limbus under a sponge [uN/mm]
    double outflow =
        0.3 / 60.0 / pascal_per_mmhg;  ///< and inflow of aqueous: towards the pressure at rest [mm^3/(s Pa)]
    double bleeding = 0.006;           ///< of the choroid, per pressure that drives it [mm^3/(s Pa)]
    std::array<Wound, wound_count> start;
    double start_burn = 0.0;  ///< of the main wound, as in burn_share()
};

/// Changes from step to step.
struct WoundsState {
    std::array<Wound, wound_count> wounds;
    int touches = 0;                     ///< of iris or lens by a blade that came out of the back of the cornea, so far
    bool touching = false;               ///< now
    int catching = -1;                   ///< tool whose tip has caught Descemet's membrane at an inner lip; -1: none
    std::size_t caught_at = main_wound;  ///< of which wound
    bool stitching = false;              ///< the needle is in the cornea
    Vec3 bite = Vec3::Zero();            ///< where it went in [mm]
    double deepest = 0.0;                ///< that it has been below the front since [mm]
    double pressed_s = 0.0;              ///< for which a sponge has pressed on the main wound [s]
    bool checked = false;                ///< it has pressed long and hard enough since the wounds were last changed
    double tested_leak = 0.0;            ///< most that came meanwhile [mm^3/s]
    double peak_press = 0.0;             ///< most force with which the outer lip was pressed so far [uN]
    double aqueous = 0.0;                ///< that the eye has made, beyond what left it by its own ways, so far [mm^3]
    double injected = 0.0;               ///< into the chamber so far [mm^3]
    double source = 0.0;  ///< pressure of bleeding behind the choroid, above the pressure at rest [Pa]; 0: none
    double behind = 0.0;  ///< blood behind the choroid [mm^3]
};

WoundsState rest_state(const WoundsModel& model);

/// A wound as from settings: cut, with two planes, outer and inner lip `tunnel` and `inset` [mm] from the limbus in a
/// unit direction across the view.
Wound made_wound(const WoundsModel& model, const Vec2& direction, double tunnel, double width, double inset);

/// How far a place is below the front of the cornea, and beyond its back into the chamber; negative: not [mm].
double below_front(const WoundsModel& model, const Vec3& place);
double beyond_back(const WoundsModel& model, const Vec3& place);

/// Distance of a place from the limbus, towards the axis [mm].
double inset_of(const WoundsModel& model, const Vec3& place);

/// How far it stands open: 0 or less, it is shut. burn: share, of the main wound; pressure: of the eye [Pa].
double gape_of(const WoundsModel& model, const Wound& wound, double burn, double pressure, double press);

/// What a wound lets through per pressure [mm^3/(s Pa)], nothing being in it.
double wound_conductance(const WoundsModel& model, const Wound& wound, double burn, double pressure, double press);

/// Of the eye's volume what is not behind the choroid [mm^3]: it makes the depth of the chamber.
double volume_in_front(const ChamberState& chamber, const WoundsState* wounds);

}  // namespace rhexis
