// SPDX-License-Identifier: GPL-3.0-or-later
// The independent answer: the same load case in CalculiX (Debian package calculix-ccx), linear and quadratic
// tetrahedra.
#pragma once

#include <map>
#include <string>

#include "base/result.hpp"
#include "scenes/lens_poke.hpp"

namespace rhexis::bench {

enum class CalculixElement { c3d4, c3d10 };

/// Depth per load [mm/uN] that CalculiX finds for the linear problem; writes its deck and results into folder.
/// The load is the nodal load of the coarse mesh for C3D4, and the same pressure integrated anew for C3D10.
Result<double> calculix_compliance(const scenes::LensPoke& poke, CalculixElement element, const std::string& folder);

/// Requested size -> what it found with C3D10 on the same mesh [mm/uN] (docs/data/calculix.csv, made by
/// `rhexis bench calculix`).
std::map<int, double> kept_compliances();

}  // namespace rhexis::bench
