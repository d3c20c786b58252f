// SPDX-License-Identifier: GPL-3.0-or-later
// What the microscope shows of the eye: a round field, sharp within a depth.
#pragma once

#include "flow/eye_model.hpp"
#include "flow/microscope.hpp"
#include "flow/percept.hpp"

namespace rhexis {

struct FieldOfView {
    double radius = 0.0;          ///< [mm]
    double depth_of_field = 0.0;  ///< [mm]
    double pupil_offset = 0.0;    ///< of the pupil's middle, as it is seen, from that of the field [mm]
    double pupil_radius = 0.0;    ///< as the cornea shows it [mm]
    double defocus = 0.0;         ///< how far over the plane of the pupil's edge it is focused [mm]

    [[nodiscard]] bool shows_whole_pupil() const { return pupil_offset + pupil_radius <= radius; }
    /// How far the pupil's plane is beyond the depth of field [mm].
    [[nodiscard]] double out_of_focus() const;
};

/// pupil: where its middle is in the room [mm].
FieldOfView field_of_view(const MicroscopeModel& model, const MicroscopeState& state, const EyeAnatomy& eye,
                          const Vec3& pupil);

/// Landmarks outside of the field do not show; the pupil does as long as a part of it is inside. Wounds stay: whoever
/// has an instrument in one feels where it is.
void look_through(const MicroscopeModel& model, const MicroscopeState& state, const EyeAnatomy& eye, const Vec3& pupil,
                  Percept& percept);

}  // namespace rhexis
