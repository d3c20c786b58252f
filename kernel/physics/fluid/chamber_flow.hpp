// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through eye and machine in time: two tanks, by implicit steps.
//
//   d eye_volume / dt  = Q_infusion - Q_tip - Q_leak       d tube_volume / dt = Q_tip + Q_vent - Q_pump
//   Q_infusion = (P_bottle - P_eye) / R_infusion           Q_tip  = (P_eye - P_tube) / (R_tube + R_tip / open)
//   Q_leak = leak max(P_eye, 0)                            Q_vent = max(-P_tube, 0) / R_vent
//   Q_pump = flow clamp((limit + P_tube) / band, 0, 1)
//
// A higher pressure never lets more into its tank, and never belongs to less volume: an implicit step has one solution
// however long it is, and Newton's method with step control finds it.
#pragma once

#include "base/result.hpp"
#include "flow/chamber.hpp"

namespace rhexis {

/// Every number finite and in its range; else the field, its value and the range.
Status check(const ChamberModel& model);
Status check(const ChamberControl& control);
Status check(const ChamberModel& model, const ChamberState& state);

/// A step [s] must be above 0 and not longer than 0.1.
Status check_chamber_step(double dt);

/// Advances by dt [s], in substeps of at most 1 ms of a second-order L-stable method [Alexander1977]. Everything must
/// pass the checks above.
ChamberFlows advance_chamber(const ChamberModel& model, const ChamberControl& control, double dt, ChamberState& state);

}  // namespace rhexis
