// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/implant_marks.hpp"

namespace rhexis {
namespace {

/// Not behind the iris: over the pupil, or before it.
bool implant_shows(const EyeAnatomy& eye, const Vec3& place, double radius = 0.0) {
    return !eye.has_iris || place.head<2>().norm() + radius < eye.pupil_radius ||
           place.z() > eye.iris_z + 0.5 * eye.iris_thickness;
}

}  // namespace

void add_implant_landmarks(const ObserveInput& input, const ImplantPlace& implant, const BagPlace* bag,
                           std::vector<Landmark>& marks) {
    const EyeAnatomy& eye = input.eye.anatomy;
    const bool here = !input.state.shells[0].loaded;
    marks.push_back({"optic", here && implant_shows(eye, implant.centre), implant.centre, implant.radius});
    const auto mark = [&](const char* name, const Vec3& place) {
        marks.push_back({name, here && implant_shows(eye, place), place, 0.0});
    };
    mark("haptic_leading", implant.tip[0]);
    mark("haptic_trailing", implant.tip[1]);
    mark("haptic_leading_middle", implant.middle[0]);
    mark("haptic_trailing_middle", implant.middle[1]);
    mark("haptic_leading_elbow", implant.elbow[0]);
    mark("haptic_trailing_elbow", implant.elbow[1]);
    if (bag != nullptr) {
        marks.push_back(
            {"bag_rim", implant_shows(eye, bag->rim_centre, bag->rim_radius), bag->rim_centre, bag->rim_radius});
        marks.push_back({"bag_equator", implant_shows(eye, bag->centre, bag->radius), bag->centre, bag->radius});
    }
    if (input.state.viscoelastic) {
        marks.push_back({"viscoelastic", true, Vec3(0.0, 0.0, eye.iris_z), input.state.viscoelastic->fill});
    }
}

}  // namespace rhexis
