// SPDX-License-Identifier: GPL-3.0-or-later
// physics -> session, observe, render: who touches what, with what force.
#pragma once

#include <array>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// The other side of a contact: rigid, another layer of the same shell, a membrane, or the jaws of a tool that hold it.
enum class ContactPartner { tool, bag, plane, dome, support, tube, layer, sheet, jaws };

/// A point of a solid or a membrane against a rigid partner, a weighted mean of up to three nodes; of one within a
/// tetrahedron the three nodes that bear most are named.
struct Contact {
    int solid = 0;                        ///< -1: of a membrane
    int membrane = -1;                    ///< -1: of a solid
    std::array<int, 3> nodes{0, -1, -1};  ///< coarse nodes; -1: unused
    std::array<double, 3> weights{1.0, 0.0, 0.0};
    ContactPartner partner = ContactPartner::tool;
    int partner_index = 0;
    Vec3 point = Vec3::Zero();    ///< [mm]
    Vec3 normal = Vec3::UnitZ();  ///< unit, from the partner into the solid
    double gap = 0.0;             ///< [mm]; negative: penetration
    Vec3 force = Vec3::Zero();    ///< on the solid, mean over the step [uN]
    bool sliding = false;
};

using ContactSet = std::vector<Contact>;

}  // namespace rhexis
