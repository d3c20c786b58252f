// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/friction.hpp"

#include <algorithm>

namespace rhexis {

namespace {

constexpr double edge = 1e-6;  ///< width of the edge of the disc, of its radius

}  // namespace

SpringResponse spring_contact(const ContactSpring& spring, double gap, const Vec3& normal, const Vec3& offset,
                              bool edge_slides) {
    SpringResponse response;
    response.normal_force = std::max(0.0, spring.normal_force(gap));
    if (response.normal_force == 0.0) {
        return response;
    }
    const double limit = spring.friction * response.normal_force;
    const double sticking = spring.stick * spring.stiffness;
    const Mat3 along = normal * normal.transpose();
    const Mat3 across = Mat3::Identity() - along;
    response.force = response.normal_force * normal;
    response.stiffness = spring.stiffness * along;
    const Vec3 tangential = offset - normal.dot(offset) * normal;
    const double size = tangential.norm();
    response.sliding = limit <= 0.0 || sticking * size > limit * (edge_slides ? 1.0 - edge : 1.0 + edge);
    if (!response.sliding) {
        response.force -= sticking * tangential;
        response.stiffness += sticking * across;
        response.stretch = size;
        return response;
    }
    if (limit <= 0.0 || size <= 0.0) {
        return response;
    }
    const Vec3 direction = tangential / size;
    response.force -= limit * direction;
    response.stiffness += (limit / size) * (across - direction * direction.transpose());
    response.stretch = limit / sticking;
    return response;
}

}  // namespace rhexis
