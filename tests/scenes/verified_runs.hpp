// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose every committed step is verified (penetration.hpp).
#pragma once

#include <string>
#include <vector>

#include "scenes/penetration.hpp"

namespace rhexis::scenes {

/// What came of a run, of one kind of contact.
struct VerifiedRun {
    std::string name;
    int triangles = 0;         ///< of the surfaces that were looked at
    int pierced_at_start = 0;  ///< edges that may go through triangles before the first step
    int steps = 0;
    std::vector<int> free_to;  ///< per depth tried: steps proven free to it
    StepFinding worst;         ///< of all steps, its deepest that of any
    int worst_step = 0;        ///< where it was deepest
    int first_crossing = -1;   ///< step; -1: every step is proven to cross nothing
    double cpu_s = 0.0;        ///< of verifying
};

/// A folded implant that a plunger pushes out of its cartridge, and that unfolds for some seconds: against itself, the
/// bore and the plunger. Three rows.
struct InjectionRun {
    double triangles = 400.0;
    bool tucked = false;     ///< folded with its haptics on its optic
    double nozzle = 2.6;     ///< [mm]
    double unfolding = 1.0;  ///< [s]
};
std::vector<VerifiedRun> verify_injection(const InjectionRun& run);

/// The same into the bag: implant against itself, the bag, the nozzle; the bag against itself.
std::vector<VerifiedRun> verify_bag_injection(double implant, double bag, double unfolding);

/// A flap of the anterior capsule, folded over and torn round by forceps by so many radians: the sheet against itself,
/// without thickness and with the distance that its layers keep.
std::vector<VerifiedRun> verify_tear(int triangles, double arc);

}  // namespace rhexis::scenes
