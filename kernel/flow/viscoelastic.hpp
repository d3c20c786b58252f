// SPDX-License-Identifier: GPL-3.0-or-later
// The anterior chamber filled with viscoelastic, as one number: how full it is. Its pressure stands against that of the
// vitreous behind the lens; what is missing pushes the lens forward and domes its capsule.
#pragma once

#include "flow/chamber.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct ViscoelasticModel {
    double start_fill = 1.0;                             ///< share of the chamber at the start
    double volume = 250.0;                               ///< of the chamber [mm^3]
    double vitreous_pressure = 10.0 * pascal_per_mmhg;   ///< above the air's [Pa]
    double area = 70.0;                                  ///< of lens and zonules, on which pressure acts [mm^2]
    double overfill_pressure = 300.0 * pascal_per_mmhg;  ///< per share of the volume beyond full [Pa]. Proposal
    double leak = 0.004;                                 ///< share per second and instrument in a wound. Proposal
    double injection = 40.0;                             ///< of a syringe pressed with full force [mm^3/s]. Proposal
    double inner_radius = 5.8;                           ///< from the axis, within which an instrument is inside [mm]
};

/// Changes from step to step.
struct ViscoelasticState {
    double fill = 1.0;       ///< share of the chamber; above 1: stretched
    double injected = 0.0;   ///< so far [mm^3]
    double peak_fill = 1.0;  ///< so far
};

/// Of the chamber, above the air's [Pa]: that of the vitreous where it is full, in proportion where it is not.
double viscoelastic_pressure(const ViscoelasticModel& model, const ViscoelasticState& state);

}  // namespace rhexis
