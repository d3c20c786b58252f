// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/stability_gates.hpp"

#include <array>

namespace rhexis::scenes {

std::span<const GateGroup> stability_gates() {
    static constexpr std::array<GateGroup, 17> groups{{
        {"T1", "bodies released from random, flat or mirrored places", gates_of_bad_starts},
        {"T2", "a bar bent and twisted by 180 degrees, steps up to 100 s", gates_of_big_turns},
        {"T3", "Poisson's ratio up to 0.499", gates_of_stiff_volume},
        {"T4", "one sliver", gates_of_slivers},
        {"T5", "a taut sheet", gates_of_taut_sheets},
        {"T6", "a crumpled sheet", gates_of_slack_sheets},
        {"T7", "fibres at every angle", gates_of_fibres},
        {"T8", "a sheet renumbered and turned", gates_of_numbering},
        {"T11", "a tool at 1 m/s, 1 cm a step", gates_of_strikes},
        {"T14", "an incline 1 % below and above the angle of friction", gates_of_inclines},
        {"T16", "a preconditioner as old as the run", gates_of_stale_factors},
        {"T17", "tetrahedra removed at random, to the last", gates_of_deletion},
        {"T18", "a sheet split in every step, and at random", gates_of_random_tears},
        {"T19", "a tear on finer, jittered and rotated meshes", gates_of_tear_meshes},
        {"T20", "free flight: momentum", gates_of_momentum},
        {"T21", "free flight: energy", gates_of_energy},
        {"T22", "samples lost, a spike of 200 ms, a pause", gates_of_input},
    }};
    return groups;
}

}  // namespace rhexis::scenes
