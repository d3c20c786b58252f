// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/friction.hpp"

namespace rhexis {

Vec3 project_on_disc(const Vec3& tangential, double radius) {
    const double size = tangential.norm();
    return size <= radius ? tangential : Vec3((radius / size) * tangential);
}

SpringResponse spring_contact(const ContactSpring& spring, double gap, const Vec3& normal, const Vec3& offset) {
    SpringResponse response;
    if (gap >= 0.0) {
        return response;
    }
    const double depth = -gap;
    const bool soft = depth < spring.softness;
    const double slope = soft ? spring.stiffness * depth / spring.softness : spring.stiffness;
    response.normal_force = soft ? 0.5 * slope * depth : spring.stiffness * (depth - 0.5 * spring.softness);
    const Mat3 along = normal * normal.transpose();
    const Mat3 across = Mat3::Identity() - along;
    response.force = response.normal_force * normal;
    response.stiffness = slope * along;
    const Vec3 tangential = offset - normal.dot(offset) * normal;
    const double size = tangential.norm();
    const double limit = spring.friction * response.normal_force;
    response.sliding = spring.stiffness * size > limit;
    if (!response.sliding) {
        response.force -= spring.stiffness * tangential;
        response.stiffness += spring.stiffness * across;
        response.stretch = size;
        return response;
    }
    // The coupling of the tangential force to the depth is not symmetric and is left to the iterations.
    const Vec3 direction = tangential / size;
    response.force -= limit * direction;
    response.stiffness += (limit / size) * (across - direction * direction.transpose());
    response.stretch = limit / spring.stiffness;
    return response;
}

}  // namespace rhexis
