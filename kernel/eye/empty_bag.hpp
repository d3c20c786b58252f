// SPDX-License-Identifier: GPL-3.0-or-later
// The capsular bag from which the lens has been taken, filled with viscoelastic: one closed sheet of anterior and
// posterior capsule with the opening that was torn, on its zonules, before the vitreous. An implant goes into it.
#pragma once

#include <vector>

#include "flow/eye_model.hpp"
#include "flow/membrane.hpp"
#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

struct EmptyBagSettings {
    int triangles = 800;            ///< about so many, 300 to 8,000
    double opening_radius = 2.6;    ///< of an opening that is a circle [mm], 1 to 4
    std::vector<double> opening{};  ///< or its edge, as check_opening says
    double rim_strength = 1.0;      ///< of the opening's edge, share of the stretch that it bears, 0.1 to 2
    double friction = 0.1;          ///< Coulomb coefficient, on what lies in it, 0 to 10
};

/// The edge of an opening by its distance from the axis in 16 to 1,024 directions, from +x on evenly: 1 to 4 mm, from
/// one to the next by at most 1 mm more or less. Fails with what is wrong and what is allowed; none is a circle.
Status check_opening(const std::vector<double>& opening);

/// Fails with the field and what is allowed.
Status check_empty_bag(const EmptyBagSettings& settings);

/// lens: whose contour the bag keeps; bag: whose zonules hold it. age: [years], 20 to 95. The settings must pass
/// check_empty_bag. Nodes on the equator come after those of the posterior capsule and before those of the anterior;
/// front is outside.
MembraneModel make_empty_bag(const HalfEllipsoids& lens, const BagModel& bag, double age,
                             const EmptyBagSettings& settings);

}  // namespace rhexis
