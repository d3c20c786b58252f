// SPDX-License-Identifier: GPL-3.0-or-later
// The stability gates: what is provoked, what was measured, what it may be. Tests run them short, `rhexis bench
// stability` long.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace rhexis::scenes {

struct Gate {
    std::string id;         ///< "T14 explicit sticks at 30 degrees"
    std::string what;       ///< what is measured, with its unit
    double measured = 0.0;  ///< not a number: failed
    double limit = 0.0;     ///< largest value that passes
    [[nodiscard]] bool passed() const { return measured <= limit; }
};
using Gates = std::vector<Gate>;

struct GateGroup {
    const char* id;    ///< "T14"
    const char* what;  ///< what is provoked
    const char* why;   ///< of what its limits allow, where that is more than one would wish; else empty
    /// quick: smaller and shorter, seconds at most.
    Gates (*run)(bool quick);
};

/// In the order of their numbers.
std::span<const GateGroup> stability_gates();

// Parts of the table, by what they provoke.
Gates gates_of_bad_starts(bool quick);      // T1
Gates gates_of_big_turns(bool quick);       // T2
Gates gates_of_stiff_volume(bool quick);    // T3
Gates gates_of_slivers(bool quick);         // T4
Gates gates_of_taut_sheets(bool quick);     // T5
Gates gates_of_slack_sheets(bool quick);    // T6
Gates gates_of_fibres(bool quick);          // T7
Gates gates_of_numbering(bool quick);       // T8
Gates gates_of_flat_shells(bool quick);     // T9
Gates gates_of_snaps(bool quick);           // T10
Gates gates_of_strikes(bool quick);         // T11
Gates gates_of_jaws(bool quick);            // T12
Gates gates_of_stacks(bool quick);          // T13
Gates gates_of_inclines(bool quick);        // T14
Gates gates_of_turned_contact(bool quick);  // T15
Gates gates_of_stale_factors(bool quick);   // T16
Gates gates_of_deletion(bool quick);        // T17
Gates gates_of_random_tears(bool quick);    // T18
Gates gates_of_tear_meshes(bool quick);     // T19
Gates gates_of_momentum(bool quick);        // T20
Gates gates_of_energy(bool quick);          // T21
Gates gates_of_input(bool quick);           // T22
Gates gates_of_pieces(bool quick);          // T23
Gates gates_of_cracks(bool quick);          // T24
Gates gates_of_implants(bool quick);        // T26
Gates gates_of_lumped_models(bool quick);   // T27
Gates gates_of_suction(bool quick);         // T25

}  // namespace rhexis::scenes
