// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/bag.hpp"

#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

SurfaceDistance bag_distance(const BagShape& shape, const Vec3& point) {
    const SurfacePoint closest = closest_on({shape.radius, shape.anterior, shape.posterior}, point);
    return {closest.distance, closest.normal};
}

namespace {

Vec3 along(const ZonuleSpring& spring, const Pose& bag) { return bag.to_world(spring.on_bag) - spring.on_ciliary; }

double rest_length(const ZonuleSpring& spring) { return (spring.on_bag - spring.on_ciliary).norm(); }

}  // namespace

Vec3 zonule_force(const ZonuleSpring& spring, const Pose& bag) {
    const Vec3 line = along(spring, bag);
    const double length = line.norm();
    return length > 0.0 ? Vec3(-spring.stiffness * (length - rest_length(spring)) / length * line) : Vec3::Zero();
}

Mat3 zonule_stiffness(const ZonuleSpring& spring, const Pose& bag) {
    const Vec3 direction = along(spring, bag).normalized();
    return spring.stiffness * direction * direction.transpose();
}

double zonule_strain(const ZonuleSpring& spring, const Pose& bag) {
    return along(spring, bag).norm() / rest_length(spring) - 1.0;
}

}  // namespace rhexis
