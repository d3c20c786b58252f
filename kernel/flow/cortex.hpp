// SPDX-License-Identifier: GPL-3.0-or-later
// Cortex that is left on the inner wall of the bag, in cells, and a mouth that holds and strips it. Formulas, sources
// and limits: docs/bag_contents.md.
#pragma once

#include <vector>

#include "flow/bag.hpp"
#include "flow/bag_cells.hpp"
#include "flow/chamber.hpp"
#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct CortexModel {
    BagCells cells{16, 3, 4.6};
    double volume = 0.8;                      ///< of one cell [mm^3]. Proposal
    double adhesion = 1000.0;                 ///< pull that strips it from the capsule [uN]. Proposal
    double stiffness = 3000.0;                ///< of what a mouth holds, pulled away [uN/mm]. Proposal
    double slack = 0.5;                       ///< way that a mouth can go before it pulls [mm]. Proposal
    double reach = 0.9;                       ///< of a mouth: cortex within it comes [mm]. Proposal
    double holding = 40.0 * pascal_per_mmhg;  ///< suction from which a mouth holds cortex [Pa]. Proposal
    double strip_rate = 2.0;                  ///< of it at twice the pull that strips [1/s]. Proposal
    double beside = 0.3;                      ///< share of that by which the neighbouring sectors come too. Proposal
    double draw = 0.1;                        ///< share of the flow into a mouth that is cortex. Proposal
    double start_left = 1.0;                  ///< share of the sectors that have cortex
};

/// Changes from step to step.
struct CortexState {
    std::vector<double> volume;    ///< per cell [mm^3]
    std::vector<double> attached;  ///< per cell, share that still adheres
    int tool = -1;                 ///< whose mouth lies in cortex; -1: none
    int cell = -1;                 ///< in which
    bool held = false;             ///< by suction
    Vec3 place = Vec3::Zero();     ///< of that cell on the wall, in the bag's frame [mm]
    Vec3 pull = Vec3::Zero();      ///< on the bag there, in the world's frame [uN]
    double taken = 0.0;            ///< aspirated so far [mm^3]
};

CortexState rest_state(const CortexModel& model);

/// Middle of a cell on the wall of the bag, in its frame: the last ring lies in the fornix, the others on the back.
Vec3 cortex_place(const CortexModel& model, const BagShape& bag, int cell);

/// Area that cortex covers, share of the bag's as the microscope shows it.
double cortex_left(const CortexModel& model, const CortexState& state);

}  // namespace rhexis
