// SPDX-License-Identifier: GPL-3.0-or-later
// The iris in the main wound: what the pressure of the eye pushes into it, what holds it there, and what a push on it
// does to it. One length. Formulas, sources and limits: docs/prolapse.md.
#pragma once

#include "flow/chamber.hpp"

namespace rhexis {

/// Constant while a scene runs. Those without a source are proposals.
struct ProlapseModel {
    double near = 0.35;  ///< gap between inner lip and iris at which half of the pressure falls there [mm]
    double holds = 5.0 * pascal_per_mmhg;  ///< pressure over the iris that its root bears [Pa]
    double patch = 0.5;                    ///< of iris that the pressure acts on, per width of the wound [mm]
    double stiffness = 2000.0;             ///< of iris drawn out [uN/mm]
    double friction = 1500.0;              ///< of the tunnel on it [uN]
    double stroked = 0.1;                  ///< share of that under a stroking instrument
    double stroke_s = 0.3;                 ///< for which a stroke acts [s]
    double stroke_reach = 1.0;             ///< from the middle of the outer lip [mm], beside half its width
    double stroke_speed = 0.5;             ///< slower than this is no stroke [mm/s]
    double drag = 1500.0;                  ///< [uN s/mm]
    double longest = 6.0;                  ///< [mm]
    double plugs = 0.9;                    ///< share of the wound's leak that iris in it stops
    double damage = 0.1;                   ///< by each mm that it is pushed back, twice as much at 20 mmHg
    double softer = 0.5;                   ///< share of its stiffness that full damage takes
    double narrows = 0.05;                 ///< of the pupil by each mm, share of its radius
    double narrows_damaged = 0.15;         ///< by full damage
};

/// Changes from step to step.
struct ProlapseState {
    double length = 0.0;    ///< of iris outside the inner lip [mm]
    double most = 0.0;      ///< the greatest so far [mm]
    double damage = 0.0;    ///< 0 none, 1 torn to shreds
    double pushed = 0.0;    ///< pushed back into the eye so far [mm]
    double stroke_s = 0.0;  ///< for which the last stroke still acts [s]
    double pull = 0.0;      ///< pressure that drives it out [Pa]
};

/// Share of the wound's leak that the iris in it leaves.
double unplugged_share(const ProlapseModel& model, const ProlapseState& state);

}  // namespace rhexis
