// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/capsular_bag.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "eye/anatomy.hpp"
#include "eye/table.hpp"
#include "eye/tissue_numbers.hpp"

namespace rhexis {

namespace {

constexpr int meridians = 24;
constexpr double clearance = 0.03;       ///< bag outside the lens's contour [mm]
constexpr double ciliary_gap = 1.25;     ///< from the equator to the ciliary ring [mm]
constexpr double anterior_inset = 1.25;  ///< of the anterior insertion inside the equator, seen along the axis [mm]
constexpr double posterior_inset = 0.75;
constexpr double bag_mass = 0.01;      ///< [g]
constexpr double damping_ratio = 0.7;  ///< of the axial motion of bag and lens together
constexpr double opening_radius = 2.6;

/// Unit vectors 15 degrees apart. By roots and products only: the library's sine may differ in its last bit between
/// processors.
std::vector<Vec3> meridian_directions() {
    const double cosine = 0.25 * (std::sqrt(6.0) + std::sqrt(2.0));
    const double sine = 0.25 * (std::sqrt(6.0) - std::sqrt(2.0));
    std::vector<Vec3> directions{Vec3::UnitX()};
    while (directions.size() < meridians) {
        const Vec3& last = directions.back();
        directions.emplace_back(cosine * last.x() - sine * last.y(), sine * last.x() + cosine * last.y(), 0.0);
    }
    return directions;
}

std::vector<ZonuleSpring> place_zonules(const HalfEllipsoids& bag) {
    std::vector<ZonuleSpring> zonules;
    const double anterior_rho = bag.radius - anterior_inset;
    const double posterior_rho = bag.radius - posterior_inset;
    for (const Vec3& direction : meridian_directions()) {
        const Vec3 ciliary = (bag.radius + ciliary_gap) * direction;
        const Vec3 anterior = anterior_rho * direction + anterior_z(bag, anterior_rho) * Vec3::UnitZ();
        const Vec3 posterior = posterior_rho * direction + posterior_z(bag, posterior_rho) * Vec3::UnitZ();
        zonules.push_back({anterior, ciliary, 1.0});
        zonules.push_back({posterior, ciliary, 1.0});
    }
    return zonules;
}

}  // namespace

double zonule_ring_stiffness(double age) { return linear_between(zonule_ring_stiffness_by_age, age); }

double suspension_stiffness(const BagModel& bag, const Vec3& direction) {
    double sum = 0.0;
    for (const ZonuleSpring& spring : bag.zonules) {
        sum += direction.dot(zonule_stiffness(spring, Pose{}) * direction);
    }
    return sum;
}

Vec3 ciliary_place(const Vec3& node, const ZonuleSpring& zonule) {
    const auto across = [](const Vec3& place) { return std::sqrt(place.x() * place.x() + place.y() * place.y()); };
    return across(zonule.on_ciliary) / across(node) * Vec3(node.x(), node.y(), 0.0) +
           zonule.on_ciliary.z() * Vec3::UnitZ();
}

BagModel make_bag(const HalfEllipsoids& lens, double lens_mass, double age) {
    BagModel bag;
    bag.shape = {lens.radius + clearance, lens.anterior + clearance, lens.posterior + clearance};
    bag.zonules = place_zonules({bag.shape.radius, bag.shape.anterior, bag.shape.posterior});
    const double ring = zonule_ring_stiffness(age);
    const double each = ring / suspension_stiffness(bag, Vec3::UnitZ());
    for (ZonuleSpring& spring : bag.zonules) {
        spring.stiffness = each;
    }
    bag.mass = bag_mass;
    bag.damping = 2.0 * damping_ratio * std::sqrt(ring * (bag_mass + lens_mass));
    bag.opening_radius = opening_radius;
    return bag;
}

}  // namespace rhexis
