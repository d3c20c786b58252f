// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that tear at loads that theory knows.
#pragma once

#include <memory>

#include "scenes/membranes.hpp"
#include "topology/tear.hpp"

namespace rhexis::scenes {

struct TearLoad {
    double measured = 0.0;  ///< energy release at which the tear went on, mean over its steps [uN/mm]
    double expected = 0.0;  ///< toughness [uN/mm]
    int steps = 0;
};

/// A strip of 12 x 2 mm with a notch of 4 mm in its middle, gripped along its long edges and pulled apart until it
/// tears: far ahead of the tip the sheet stores W per volume, and W H0 comes free. toughness [uN/mm].
TearLoad pure_shear(int triangles, double toughness);

/// A strip of 10 x 4 mm, slit from one end along its middle; its two legs are pulled up and down, out of its plane. Per
/// leg of width b, stretch lambda and energy per volume w, F lambda / h - b w comes free [RivlinThomas1953].
TearLoad trousers(int triangles, double toughness);

struct MiddleCrack {
    std::unique_ptr<HeldSheet> sheet;  ///< at rest under the pull, tips of the crack in its state
    double half_length = 0.0;          ///< [mm]
    double release = 0.0;              ///< by the domain integral, mean of the two tips [uN/mm]
    double expected = 0.0;             ///< sigma^2 pi a / E sec(pi a / 2 b) with its polynomial [Tada1973] [uN/mm]
};
/// A square of 10 mm with a straight crack of 2 mm across the pull in its middle, at small strain.
MiddleCrack middle_crack(int triangles);

struct FacingSlits {
    int tips = 0;
    double inner = 0.0;  ///< energy release by the domain integral, mean of the two tips that face each other [uN/mm]
    double blind = 0.0;  ///< the same by an integral that takes no notice of other tips
    double outer = 0.0;  ///< of the other two
    double expected_inner = 0.0;  ///< of two such slits in an endless plate [Willmore1949]
    double expected_outer = 0.0;
};
/// The same square with two slits in one line across the pull, their far ends 1.3 mm from the middle.
/// gap: between them, as the cuts end within 0.05 mm [mm].
FacingSlits facing_slits(int triangles, double gap);

/// One step of a tear that may go on: proposals carried out at the tip with the most energy. True if one was.
bool tear_once(const MembraneModel& model, MembraneState& state, const TearRules& rules = {});

}  // namespace rhexis::scenes
