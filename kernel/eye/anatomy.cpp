// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/anatomy.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double iris_clearance = 0.1;  ///< from the lens to the back of the iris at the pupil's edge [mm]

/// Main wound: how far its inner lip lies inside the limbus. A tunnel of 2 mm from the limbus, along the sloping
/// cornea; so the sleeve of an instrument clears the iris.
constexpr double wound_inset = 1.8;

/// The side port is cut straight through, with a shorter tunnel, for the surgeon's left hand: 80 degrees from the main
/// wound (60 to 100 are usual).
constexpr double port_inset = 1.5;
constexpr double port_sine = 0.17364817766693033;  ///< of the 10 degrees that it lies in front of the left side
constexpr double port_cosine = 0.98480775301220802;

double sphere_sag(double radius, double rho) { return radius - std::sqrt(radius * radius - rho * rho); }

/// 3.02 +- 0.45 mm at 68.6 +- 11.0 years, correlation -0.29 [BmcBiometry2021].
double chamber_depth(double age) { return 3.02 - 0.29 * 0.45 / 11.0 * (age - 68.6); }

double half_profile(double radius, double axis, double rho) {
    const double share = rho / radius;
    return axis * std::sqrt(std::max(0.0, 1.0 - share * share));
}

/// On the back of the cornea, `inset` inside the limbus, in a unit direction across the view.
Vec3 inner_lip(const EyeAnatomy& eye, double inset, const Vec2& direction) {
    const double rho = eye.limbus_radius - inset;
    const double back_apex = eye.cornea_apex_z - eye.cornea_thickness;
    return {rho * direction.x(), rho * direction.y(), back_apex - sphere_sag(eye.cornea_back_radius, rho)};
}

}  // namespace

HalfEllipsoids lens_shape(const Patient& patient) {
    const double thickness = 2.93 + 0.024 * patient.age;
    const double diameter = 8.70 + 0.0138 * patient.age;
    const double anterior = thickness * 0.70 / 1.70;
    return {0.5 * diameter, anterior, thickness - anterior};
}

double anterior_z(const HalfEllipsoids& shape, double rho) { return half_profile(shape.radius, shape.anterior, rho); }

double posterior_z(const HalfEllipsoids& shape, double rho) {
    return -half_profile(shape.radius, shape.posterior, rho);
}

EyeAnatomy make_anatomy(const Patient& patient) {
    const HalfEllipsoids lens = lens_shape(patient);
    EyeAnatomy eye;
    eye.anterior_chamber_depth = chamber_depth(patient.age);
    eye.cornea_apex_z = lens.anterior + eye.anterior_chamber_depth;
    eye.limbus_z = eye.cornea_apex_z - sphere_sag(eye.cornea_radius, eye.limbus_radius);
    eye.cortical_opacity = patient.cortical_opacity;
    eye.pupil_radius = 0.5 * patient.pupil_mm;
    eye.iris_z = anterior_z(lens, eye.pupil_radius) + iris_clearance + 0.5 * eye.iris_thickness;
    eye.incision = inner_lip(eye, wound_inset, Vec2(0.0, -1.0));  // the surgeon sits at -y
    eye.side_port = inner_lip(eye, port_inset, Vec2(-port_cosine, -port_sine));
    return eye;
}

}  // namespace rhexis
