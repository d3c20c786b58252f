// SPDX-License-Identifier: GPL-3.0-or-later
// The anterior capsule of a patient as a membrane: from the pole to beyond the insertion of the zonules, on the lens as
// a smooth rigid body. Zonule springs hold it, and where it ends the capsule that goes on does; the vitreous holds the
// lens.
#pragma once

#include <cstdint>

#include "flow/eye_model.hpp"
#include "flow/membrane.hpp"
#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

struct AnteriorCapsuleSettings {
    int triangles = 1500;    ///< about so many, 200 to 20,000
    bool circles = false;    ///< fibres in circles about the pole [Dequidt2013]; false: isotropic, as anatomy has it
    double toughness = 1.0;  ///< share of the standard one
    double zonule_tension = 1.0;  ///< of the anterior zonules at rest, share of the standard one, 0 to 2
    std::uint64_t mesh_seed = 1;  ///< moves the nodes of the mesh: another one of the same capsule
};

/// Thickness at a distance from the axis [mm], where the equator is at another [mm]: 11 um at the pole at birth to 15
/// in old age, 13.5 to 16 in the mid-periphery, 7 at the equator [Barraquer2006]; straight lines between.
double anterior_thickness(double age, double rho, double equator);

/// lens: its contour; bag: whose zonules, as stiff as they are there, hold this sheet: the anterior ones where they
/// insert, the posterior ones at its edge, in place of the rest of the bag. The edge also hangs on the capsule that
/// goes on round the equator, which lies on the lens and goes with it. age: [years], 20 to 95.
MembraneModel make_anterior_capsule(const HalfEllipsoids& lens, const BagModel& bag, double age,
                                    const AnteriorCapsuleSettings& settings);

}  // namespace rhexis
