// SPDX-License-Identifier: GPL-3.0-or-later
// Viscoelastic that is still in the eye once the implant lies in the bag: in front of its optic, behind it, and in the
// angle of the chamber. The implant is a disc here. Formulas, sources and limits: docs/bag_contents.md.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs.
struct RetainedViscoelasticModel {
    double optic_radius = 3.0;  ///< [mm]
    double optic_z = -0.6;      ///< its plane in the bag's frame [mm]
    double optic_half = 0.3;    ///< half its thickness [mm]
    double under = 2.0;         ///< a mouth so far below its plane still takes from behind it [mm]
    double beside = 0.5;        ///< and so far beyond its edge [mm]. Proposal
    double draw = 0.8;          ///< share of the flow into a mouth amid viscoelastic that is taken. Proposal
    double whole = 10.0;        ///< volume about a mouth of which half of that is taken [mm^3]. Proposal
    double rocked_draw = 0.35;  ///< share of it that comes from behind an optic that is rocked. Proposal
    double wash = 0.02;         ///< of what lies in front, by 20 ml/min of irrigation [1/s]. Proposal
    double angle_draw = 0.05;   ///< of the flow into a mouth in front that is taken from the angle. Proposal
    double most_tilt = 0.3;     ///< depth to which a tip presses the optic's edge [mm]. Proposal
    double start_front = 0.0;   ///< [mm^3]
    double start_behind = 0.0;
    double start_angle = 0.0;
};

/// Changes from step to step [mm^3].
struct RetainedViscoelasticState {
    double front = 0.0;
    double behind = 0.0;
    double angle = 0.0;
    double taken = 0.0;   ///< through the tip or with the fluid so far
    double rocked = 0.0;  ///< 0 to 1: how far the tip tilts the optic now
    double under = 0.0;   ///< 1: the mouth lies behind the optic
};

RetainedViscoelasticState rest_state(const RetainedViscoelasticModel& model);

double viscoelastic_left(const RetainedViscoelasticState& state);  ///< all of it
double viscoelastic_at_start(const RetainedViscoelasticModel& model);

}  // namespace rhexis
