// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a foldable lens where the lens was, flat or folded.
#pragma once

#include "scenes/pictures.hpp"
#include "scenes/shells.hpp"

namespace rhexis::testing {

/// An eye with an implant and nothing else in its pupil.
inline Frame implant_frame() {
    Patient patient;
    patient.tetrahedra = 500;
    const EyeModel eye = make_eye(patient).value();
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    model->shells.push_back(acrylic_implant());
    const ShellState shell = rest_state(model->shells[0]);
    Frame frame = frame_of(std::shared_ptr<const WorldModel>(std::move(model)));
    frame.shells.push_back(shell);
    frame.eye = std::make_shared<const EyeAnatomy>(eye.anatomy);
    return frame;
}

/// Presses the sides of its optic together [uN].
inline void fold(Frame& frame, double force) {
    frame.shells[0] = scenes::folded_state(scenes::folded_optic(ImplantShape{}.triangles), force);
}

}  // namespace rhexis::testing
