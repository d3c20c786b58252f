// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: saline under the rim of the capsulorhexis. docs/bag_contents.md has the formulas.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Before the chamber advances: what syringes press into bag and chamber, the wave, and what comes out past the
/// nucleus; frees the cortex that the wave has parted.
void hydrodissect(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

/// How far the wound opens beside a cannula, times the leak of the wound. pressure: of the eye [Pa].
double hydrodissection_release(const HydrodissectionModel& model, std::span<const ToolState> tools, double pressure);

/// Once it has advanced: what has left with the fluid, and whether the posterior capsule burst.
void strain_by_trapped(const WorldModel& model, double dt, WorldState& state);

/// Of the posterior capsule by a pressure in the bag [Pa].
double trapped_strain(const WorldModel& model, double pressure);

/// Pressure of a bag that holds so much trapped fluid [Pa].
double trapped_pressure(const HydrodissectionModel& model, double trapped);

}  // namespace rhexis
