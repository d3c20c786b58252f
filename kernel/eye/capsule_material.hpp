// SPDX-License-Identifier: GPL-3.0-or-later
// What the capsule of the lens is made of, wherever it is modelled as a membrane.
#pragma once

namespace rhexis {

inline constexpr double capsule_poisson_ratio = 0.47;  ///< [Krag1997]
/// With it the first pull of forceps comes to the published 11.7 mN in the mean [CapsulorhexisFe]: calibrated by
/// `rhexis bench capsule_pulls` at 68 years. Tear forces of 5 to 19 mN, [Han2021] too, allow 0.7 to 2.7 kJ/m^2 [uN/mm].
inline constexpr double capsule_toughness = 1.2e6;
inline constexpr double capsule_piercing_force = 22000.0;    ///< needles went through at 15 to 35 mN [Jmbbm2016] [uN]
inline constexpr double capsule_piercing_thickness = 0.015;  ///< of what they went through [mm]
inline constexpr double viscoelastic_drag = 3e6;             ///< on it, share of its mass [1/s]. Proposal
inline constexpr double capsule_at_equator = 0.007;          ///< its thickness [Barraquer2006] [mm]

}  // namespace rhexis
