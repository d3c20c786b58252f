// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/field.hpp"

#include <algorithm>
#include <cmath>

#include "flow/corneal_image.hpp"

namespace rhexis {
namespace {

bool is_felt(const Landmark& mark) { return mark.name == "incision" || mark.name == "side_port"; }

/// The microscope is far away: what it shows lies straight under it, larger where it is seen through the cornea.
double offset_of(const MicroscopeState& state, const EyeAnatomy& eye, const Vec3& place) {
    const bool through_cornea = place.head<2>().norm() < eye.limbus_radius;
    const double larger = through_cornea ? corneal_magnification(eye, place.z()) : 1.0;
    return (larger * place.head<2>() - state.position.head<2>()).norm();
}

}  // namespace

double FieldOfView::out_of_focus() const { return std::max(0.0, std::abs(defocus) - 0.5 * depth_of_field); }

FieldOfView field_of_view(const MicroscopeModel& model, const MicroscopeState& state, const EyeAnatomy& eye,
                          const Vec3& pupil) {
    FieldOfView field;
    field.radius = model.field_radius;
    field.depth_of_field = model.depth_of_field;
    field.pupil_offset = offset_of(state, eye, pupil);
    field.pupil_radius = corneal_magnification(eye, eye.iris_z) * eye.pupil_radius;
    field.defocus = state.position.z() - pupil.z();
    return field;
}

void look_through(const MicroscopeModel& model, const MicroscopeState& state, const EyeAnatomy& eye, const Vec3& pupil,
                  Percept& percept) {
    const FieldOfView field = field_of_view(model, state, eye, pupil);
    percept.field = PerceivedField{state.position, field.radius, field.out_of_focus()};
    for (Landmark& mark : percept.landmarks) {
        const double reach = mark.name == "pupil" ? field.radius + field.pupil_radius : field.radius;
        mark.visible = mark.visible && (is_felt(mark) || offset_of(state, eye, mark.position) < reach);
    }
}

}  // namespace rhexis
