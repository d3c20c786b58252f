// SPDX-License-Identifier: GPL-3.0-or-later
// Saline that parts the cortex from the capsule: the wave over the back of the bag, what is trapped there, and the way
// out past the nucleus. Formulas, sources and limits: docs/bag_contents.md.
#pragma once

#include <vector>

#include "flow/bag_cells.hpp"
#include "flow/chamber.hpp"
#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct HydrodissectionModel {
    BagCells cells;
    std::vector<int> cell_of_node;                   ///< per coarse node of the lens
    double opening_radius = 2.6;                     ///< of the capsulorhexis [mm]
    double injection = 250.0;                        ///< of a syringe pressed with full force [mm^3/s]. Proposal
    double most_pressure = 400.0 * pascal_per_mmhg;  ///< against which a hand can press [Pa]. Proposal
    double under = 0.9;   ///< the end of a cannula lies under the rim within this of the capsule [mm]. Proposal
    double layer = 0.12;  ///< thickness of the wave [mm]. Proposal
    double cleaving = 1.0 * pascal_per_mmhg;  ///< pressure that parts cortex from capsule [Pa]. Proposal
    double reach = 14.0;  ///< of the wave from where it starts, as far as pressure goes for nothing [mm]. Proposal
    double wave_flow = 4.0 / pascal_per_mmhg;  ///< into the wave per pressure [mm^3/(s Pa)]. Proposal
    double stiffness = 0.5 * pascal_per_mmhg;  ///< of the bag that holds trapped fluid [Pa/mm^3]. Proposal
    double stiffening = 30.0;                  ///< volume that doubles it [mm^3]. Proposal
    double lens_area = 60.0;                   ///< by which trapped fluid moves the lens [mm^2]
    double egress = 67.0 / pascal_per_mmhg;    ///< past the nucleus, per pressure [mm^3/(s Pa)]. Proposal
    double seal = 0.35;                        ///< forward, the nucleus shuts the opening [mm]. Proposal
    double sealed = 0.001;                     ///< share of the egress that stays when it does. Proposal
    double wall_share = 0.1;                   ///< of the pressure that the capsule bears; rest: vitreous. Proposal
    double first_tear = 1.0;                   ///< radius of the hole when the capsule bursts [mm]. Proposal
    double sink = 2.0e4;                       ///< with which the lens then falls back there [uN]. Proposal
    double lifts = 40.0;                       ///< viscoelastic under the lens that holds it up [mm^3]. Proposal
    double chamber_volume = 250.0;             ///< of the anterior chamber [mm^3]
    double lip = 12.0 * pascal_per_mmhg;       ///< from which the wound beside a cannula opens [Pa]. Proposal
    double gape = 10.0;                        ///< how far, times the leak of the wound. Proposal
    double start_fill = 0.8;                   ///< share of the chamber that viscoelastic fills
    double start_cleaved = 0.0;                ///< share of the cortex that is free
};

/// Changes from step to step. Volumes in mm^3.
struct HydrodissectionState {
    std::vector<double> cleaved;  ///< per cell, share that the wave has parted
    Vec3 entry = Vec3::Zero();    ///< where saline last came under the rim, in the bag's frame [mm]
    bool entered = false;         ///< it has, once
    bool under_rim = false;       ///< the end of a saline cannula lies there now
    double trapped = 0.0;         ///< behind the nucleus
    double injected = 0.0;        ///< saline so far
    double filled = 0.0;          ///< viscoelastic in the chamber
    double lifted = 0.0;          ///< viscoelastic under the lens
    double pressure = 0.0;        ///< in the bag over that of the eye [Pa]
    double peak_pressure = 0.0;   ///< so far
    double strain = 0.0;          ///< of the posterior capsule by it
    double burst_s = -1.0;        ///< since it burst [s]; -1: it did not
};

HydrodissectionState rest_state(const HydrodissectionModel& model);

double wave_share(const HydrodissectionState& state);  ///< of the posterior capsule
double viscoelastic_fill(const HydrodissectionModel& model, const HydrodissectionState& state);  ///< may exceed 1
double forward_shift(const HydrodissectionModel& model, const HydrodissectionState& state);      ///< of the lens [mm]
/// Of the pupil's radius, times that without hydrodissection: wide over a block, small after the capsule has burst.
double pupil_share(const HydrodissectionModel& model, const HydrodissectionState& state);
/// On the bag once the capsule has burst [uN], at the hole along -z.
double sinking_force(const HydrodissectionModel& model, const HydrodissectionState& state);

}  // namespace rhexis
