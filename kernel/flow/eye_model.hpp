// SPDX-License-Identifier: GPL-3.0-or-later
// eye -> session, observe, render: a patient and the anatomy made from it.
// The eye's frame: origin at the centre of the lens equator at rest, +z anterior (to the microscope), the surgeon sits
// at -y (the bottom of the picture), +x to the surgeon's right. Units mm.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "flow/bag.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// What a curriculum says of the patient. Every number is checked against the range given here.
struct Patient {
    double age = 68.0;              ///< [years], 20 to 95
    double nuclear_grade = 3.0;     ///< LOCS III nuclear opalescence, 1 to 6
    double cortical_opacity = 0.0;  ///< 0: cortex as clear as the nucleus lets it be; 1: a white cataract
    double pupil_mm = 7.5;          ///< diameter, 3 to 9
    std::string side = "right";     ///< "right" or "left"
    int tetrahedra = 3000;          ///< requested mesh size of the lens, 500 to 24000
};

/// A zone of a lens that stands still: a scaled copy of its contour, of one tissue up to the next smaller one.
struct LensZone {
    double scale = 1.0;              ///< of the lens's contour
    Vec3 extinction = Vec3::Zero();  ///< red, green, blue [1/mm]
};

/// Surfaces that only the picture and distances need.
struct EyeAnatomy {
    bool has_iris = true;         ///< of the tissues that take part
    bool has_cornea = true;       ///< and with it sclera and lids; without it nothing bends the light
    double cornea_apex_z = 0.0;   ///< front of the cornea on the axis [mm]
    double cornea_radius = 7.63;  ///< front radius of curvature [mm]
    double cornea_back_radius = 6.45;
    double cornea_thickness = 0.534;
    double limbus_radius = 5.82;  ///< half of white-to-white [mm]
    double limbus_z = 0.0;
    double globe_radius = 12.0;
    double iris_z = 0.0;  ///< plane of the pupil's edge [mm]
    double iris_thickness = 0.4;
    double pupil_radius = 3.75;
    double cortical_opacity = 0.0;        ///< as of the patient
    std::array<LensZone, 3> lens_zones;   ///< outermost first; drawn where a membrane lies on a lens that is no solid
    bool has_implant = false;             ///< drawn only: an implant lies in a bag that takes no part
    double trypan_blue = 0.0;             ///< stain of the anterior capsule: 0 none, 1 full
    double anterior_chamber_depth = 3.0;  ///< front of the cornea to front of the lens [mm]
    Vec3 incision = Vec3::Zero();         ///< centre of the main wound at its inner lip [mm]
    double incision_width = 2.4;
    double wound_burn = 0.0;        ///< of the main wound: 0 none, 1 white and shrunk
    Vec3 side_port = Vec3::Zero();  ///< centre of the second, narrow wound at its inner lip [mm]
    double side_port_width = 0.0;   ///< [mm]; 0: it is not cut, because no instrument needs it
};

/// Of the membrane that is the anterior capsule.
inline constexpr const char* anterior_capsule_name = "anterior_capsule";
/// Of the membrane that is the bag without its lens.
inline constexpr const char* empty_bag_name = "bag";

struct EyeModel {
    Patient patient;
    EyeAnatomy anatomy;
    SolidModel lens;
    BagModel bag;
};

}  // namespace rhexis
