// SPDX-License-Identifier: GPL-3.0-or-later
// A one-piece foldable lens as a thin shell: a round optic with two modified-L haptics, of acrylic.
//
//        ____            The optic in the plane z = 0 about the origin, its front to +z. Seen from the front the
//            \           haptics leave it on the right above and on the left below, go out, and turn
//       ( optic )        anticlockwise; the lens lies the right way up when they look like a 7 and an L.
//        \____           Half a turn about z brings it onto itself.
//
// Triangles are finest where the haptics meet the optic, which is where the lens folds [Dequidt2013].
#pragma once

#include "flow/implant_parts.hpp"
#include "flow/shell.hpp"

namespace rhexis {

/// Lengths in mm. Defaults: optic, overall length and haptics of a common lens [AcrySof]; thicknesses of some 21
/// dioptres, which makers do not publish.
struct ImplantShape {
    double optic_diameter = 6.0;     ///< 4 to 7.5
    double overall_diameter = 13.0;  ///< across the haptics: 10 to 14, their arms 1.5 or more from the optic
    double centre_thickness = 0.7;   ///< of the optic: 0.1 to 2
    double edge_thickness = 0.25;    ///< of the optic: 0.05 to that of the centre
    double haptic_thickness = 0.4;   ///< 0.05 to 1
    double haptic_width = 0.5;       ///< of its arm: 0.2 to 0.8
    int triangles = 743;             ///< about so many (6 per cent): 400 to 8,000
};

struct Implant : ImplantParts {
    ShellModel model;
};

/// Fails with the field and what is allowed.
Status check_implant(const ImplantShape& shape);

/// Fails on what check_implant refuses.
Result<Implant> make_implant(const ImplantShape& shape);

/// Of the lens of that shape, which must pass check_implant.
ImplantParts implant_parts(const ImplantShape& shape);

/// A lens as a scene has it: viscoelastic, at room temperature, in water, flat about the origin, free. The shape must
/// pass check_implant.
ShellModel free_implant(const ImplantShape& shape);

/// The same, held by the ends of its haptics as if they lay in the bag's fold.
ShellModel acrylic_implant(const ImplantShape& shape = {});

/// Optic at a distance from the axis [mm]: two spherical caps to their second order.
double optic_thickness(const ImplantShape& shape, double distance);

}  // namespace rhexis
