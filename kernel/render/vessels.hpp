// SPDX-License-Identifier: GPL-3.0-or-later
// Blood vessels of the conjunctiva as ribbons: trees that grow from the fornix towards the cornea, waver and branch.
#pragma once

#include <cstdint>
#include <vector>

namespace rhexis {

/// Triangles in a plane seen from above: position (2 floats, mm), then across (-1 to 1), along [mm], strength (0 to 1)
/// and layer (0 near the surface, 1 deep). The same seed gives the same vessels.
std::vector<float> vessel_ribbons(double limbus_radius, double outer_radius, std::uint64_t seed);

}  // namespace rhexis
