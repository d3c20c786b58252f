// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the one contact law of both resolvers. The normal force is unilateral; the tangential one lies in the
// disc of radius mu times it (Coulomb, no pyramid) and sticks to an anchor on the partner, so that it does not creep.
#pragma once

#include <cmath>

#include "math/types.hpp"

namespace rhexis {

/// A contact as a spring.
struct ContactSpring {
    double stiffness = 0.0;  ///< normal [uN/mm]
    double friction = 0.0;   ///< Coulomb coefficient
    double stick = 1.0;      ///< tangential stiffness over that: what sticks gives way by its force over both
    double carried = 0.0;    ///< normal force at a gap of 0 [uN]

    [[nodiscard]] double normal_force(double gap) const { return carried - gap * stiffness; }
};

struct SpringResponse {
    Vec3 force = Vec3::Zero();      ///< on the solid [uN]
    Mat3 stiffness = Mat3::Zero();  ///< -d force / d point, positive semidefinite [uN/mm]
    double normal_force = 0.0;      ///< [uN]
    double stretch = 0.0;           ///< tangential offset that the anchor may keep [mm]
    bool sliding = false;
};

/// gap [mm]; normal: unit, into the solid; offset: point less anchor [mm]. `edge_slides`: what a contact at the edge of
/// the disc is taken for; the force is the same, the stiffness is not. The stiffness leaves out that the tangential
/// force follows the normal one, which is not symmetric.
SpringResponse spring_contact(const ContactSpring& spring, double gap, const Vec3& normal, const Vec3& offset,
                              bool edge_slides);

/// The nearest point of the disc of that radius.
inline Vec3 project_on_disc(const Vec3& tangential, double radius) {
    const double square = tangential.squaredNorm();
    return square <= radius * radius ? tangential : Vec3((radius / std::sqrt(square)) * tangential);
}

}  // namespace rhexis
