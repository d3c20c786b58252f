// SPDX-License-Identifier: GPL-3.0-or-later
// The iris as chamber and instruments move it: a flat ring that goes with the diaphragm of iris and lens, whose inner
// edge can be drawn into a mouth that sucks. docs/capsule.md has the formulas.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct IrisModel {
    double rest_z = 0.0;         ///< plane of the pupil's edge [mm]
    double pupil_radius = 3.75;  ///< at rest [mm]
    double root_radius = 5.82;   ///< [mm]
    double thickness = 0.4;      ///< [mm]
    double widening = 0.08;      ///< of the pupil per mm that the diaphragm goes back, share of its radius. Proposal
    double stiffness = 8000.0;   ///< of a captured edge [uN/mm]: 20 kPa times the thickness. Proposal
    double tear_strain = 0.8;    ///< of the way from edge to root, at which it tears. Proposal
};

/// Changes from step to step.
struct IrisState {
    double z = 0.0;             ///< plane of the pupil's edge now [mm]
    double pupil_radius = 0.0;  ///< now [mm]
    int tool = -1;              ///< whose mouth holds its edge; -1: none
    Vec3 place = Vec3::Zero();  ///< of the held edge at rest [mm]
    double strain = 0.0;        ///< of the captured part now
    double torn = 0.0;          ///< arc of the edge that is torn, so far [mm]
};

/// At rest.
IrisState rest_state(const IrisModel& model);

}  // namespace rhexis
