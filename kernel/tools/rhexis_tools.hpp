// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments that open the anterior capsule.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// A 27 gauge needle, 0.4 mm thick, whose last 0.8 mm are bent down into a sharp point; its edge cuts along x.
ToolModel cystotome();

/// Forceps for a capsulorhexis: two blades bent down at their ends, which hold by friction.
ToolModel capsulorhexis_forceps();

/// A blunt cannula of 27 gauge; what the hand presses out of its syringe, viscoelastic, comes out of its end.
ToolModel viscoelastic_cannula();

/// The same with triamcinolone, which makes vitreous white.
ToolModel triamcinolone_cannula();

/// The same for hydrodissection; what comes out of it is balanced salt solution.
ToolModel saline_cannula();

}  // namespace rhexis
