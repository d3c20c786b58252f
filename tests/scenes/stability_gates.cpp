// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/stability_gates.hpp"

#include <array>

namespace rhexis::scenes {

std::span<const GateGroup> stability_gates() {
    static constexpr std::array<GateGroup, 27> groups{{
        {"T1", "bodies released from random, flat or mirrored places",
         "Mirrored, steps of 10 ms are no gate: 0.5 % of the lens's tetrahedra stay inside out, for Newton's method "
         "finds a balance there; steps of 1 ms and the explicit way go past it.",
         gates_of_bad_starts},
        {"T2", "a bar bent and twisted by 180 degrees, steps up to 100 s",
         "Where all of the turn is in the last elements, the residual may rise on the way: what the line search lowers "
         "is the energy.",
         gates_of_big_turns},
        {"T3", "Poisson's ratio up to 0.499", "", gates_of_stiff_volume},
        {"T4", "one sliver",
         "The explicit step is safe everywhere. A sliver of 0.01 is shaken by a good part of its height when its limit "
         "is looked for in single precision, and so its step is chosen too short by up to a fifth; in double precision "
         "it would not be, for the stiffness of all elements anew whenever some go. Given the inertia for a step of 20 "
         "us, as the lens of the exercises is for 500, it needs a fraction of the steps.",
         gates_of_slivers},
        {"T5", "a taut sheet", "", gates_of_taut_sheets},
        {"T6", "a crumpled sheet", "Its linear solves leave a millionth, which shows in the energy.",
         gates_of_slack_sheets},
        {"T7", "fibres at every angle", "", gates_of_fibres},
        {"T8", "a sheet renumbered and turned", "", gates_of_numbering},
        {"T9", "a flat shell under its whole load in the first step",
         "A ring that is given its whole load at once is led there by as many loads between as it takes.",
         gates_of_flat_shells},
        {"T10", "shells that snap through",
         "With tangents of the predicted stress, which need fewer iterations elsewhere, a step that does not balance "
         "leads to a false rest if it is kept; so it must be flagged. In the world it is redone in smaller steps, and "
         "none ends there. With the true stress no step fails.",
         gates_of_snaps},
        {"T11", "a tool at 1 m/s, 1 cm a step", "", gates_of_strikes},
        {"T12", "opposing jaws, and jaws that crush", "What is crushed to a fifth may jitter by a hundredth.",
         gates_of_jaws},
        {"T13", "a stack of five plates, and one of a thousand times the mass", "", gates_of_stacks},
        {"T14", "an incline 1 % below and above the angle of friction", "", gates_of_inclines},
        {"T15", "contact where the body is bent by 40 degrees, and while it is cut",
         "Steps are solved to a share of all forces, so that what is solved with kept factors and with new ones "
         "differs by as much.",
         gates_of_turned_contact},
        {"T16", "a preconditioner as old as the run", "", gates_of_stale_factors},
        {"T17", "tetrahedra removed at random, to the last", "", gates_of_deletion},
        {"T18", "a sheet split in every step, and at random", "", gates_of_random_tears},
        {"T19", "a tear on finer, jittered and rotated meshes", "", gates_of_tear_meshes},
        {"T20", "free flight: momentum",
         "Explicitly, forces are summed in single precision, and their rounding does not cancel.", gates_of_momentum},
        {"T21", "free flight: energy",
         "Explicitly, single precision heats: the same method in double precision moves a quarter as much. Which of "
         "its roundings does "
         "it is not known. Half of the stable step instead of 0.8 of it, for 1.6 times the steps, is rid of it. Any "
         "tissue's damping is far larger. Undamped, the implicit way never gains any.",
         gates_of_energy},
        {"T22", "samples lost, a spike of 200 ms, a pause",
         "A tool that leaps takes tissue with it for a part of the leap, which is twenty times what it moves in a step "
         "otherwise.",
         gates_of_input},
        {"T23", "pieces of a lens that meet and press on each other",
         "Vertices of a piece are pushed out of the nearest plane of another, which is another plane in the next step: "
         "wedges that press on each other tremble, without end and without growing. Faces that are followed from step "
         "to step would not, and cost a contact of their own. Pieces meet by the explicit way only.",
         gates_of_pieces},
        {"T24", "faces that break at random to the last, and a crack that runs",
         "Crumbs push each other apart where they broke, as pieces do.", gates_of_cracks},
        {"T25", "suction that holds, slips and comes and goes",
         "The grip leads the patch before the mouth as far as suction holds: a soft cube lags behind the tip by up to "
         "half "
         "of the way. Drawing tissue onto the mouth is work that suction does, not the tip.",
         gates_of_suction},
        {"T26", "an implant that is pushed into its bag and settles",
         "Where the optic slips out of the nozzle decides for seconds where it lies, by half a millimetre.",
         gates_of_implants},
        {"T27", "models without meshes in steps of 20 ms, settings at the ends of their ranges",
         "Where saline blocks the bag, the step in which the capsule bursts decides what follows.",
         gates_of_lumped_models},
    }};
    return groups;
}

}  // namespace rhexis::scenes
