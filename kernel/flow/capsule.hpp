// SPDX-License-Identifier: GPL-3.0-or-later
// The posterior capsule where something pushes or sucks it: a thin elastic sheet that dimples, strains and gives way.
// The rest of the bag stays the smooth rigid surface of flow/bag.hpp. Formulas and their limits: docs/capsule.md.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct CapsuleModel {
    double membrane_stiffness = 7500.0;  ///< Young's modulus times thickness [uN/mm]: 1.5 MPa, 5 um
    double thickness = 0.005;            ///< [mm] [Barraquer2006]
    double poisson_ratio = 0.47;
    double ultimate_strain = 0.45;         ///< at which it gives way; falls with age
    double tear_energy = 1.0e6;            ///< per area of crack [uN/mm], that is mJ/m^2
    double dimple_radius = 2.0;            ///< of the region that one instrument draws in [mm]. Proposal
    double ultrasound_damage = 0.8;        ///< share of its strength that full ultrasound takes from it. Proposal
    double start_hole = 0.0;               ///< radius of a hole that is there at the start [mm]; 0: none
    Vec3 start_hole_place = Vec3::Zero();  ///< on the wall in the bag's frame [mm]
    double tear_speed = 3.0;               ///< of an edge at twice the energy that it needs [mm/s]. Proposal
};

/// Changes from step to step.
struct CapsuleState {
    int tool = -1;                   ///< that dimples or holds it; -1: none
    bool captured = false;           ///< sucked onto the mouth of that tool
    Vec3 place = Vec3::Zero();       ///< of the dimple, on the wall in the bag's frame [mm]
    double depth = 0.0;              ///< of the dimple, outward: pushed; negative: drawn in [mm]
    double strain = 0.0;             ///< largest now
    Vec3 force = Vec3::Zero();       ///< on the bag [uN]
    double hole_radius = 0.0;        ///< 0: intact [mm]
    Vec3 hole_place = Vec3::Zero();  ///< on the wall in the bag's frame [mm]
    double peak_strain = 0.0;        ///< so far
};

/// Whether a point in the bag's frame lies in front of or behind the hole: there is no wall.
bool within_hole(const CapsuleState& capsule, const Vec3& local);

}  // namespace rhexis
