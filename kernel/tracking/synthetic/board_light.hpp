// SPDX-License-Identifier: GPL-3.0-or-later
// Light of a flat board with dots or chess fields.
#pragma once

#include <vector>

#include "tracking/synthetic/scene.hpp"
#include "tracking/synthetic/sensor.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

struct BoardScratch {
    std::vector<float> light{};  ///< of a part of the image
    std::vector<float> line{};
};

/// Boards of a scene in the camera's frame; where several overlap, their light adds up. Rays meet the board, 8 x 8 in a
/// pixel where an edge of its pattern may be and one elsewhere; blurred as spheres are. A board is drawn where it is
/// seen from before, all of it before the camera.
void add_boards(const TrueCamera& camera, const Scene& seen, BoardScratch& scratch, LightField& field);

}  // namespace rhexis::tracking::synthetic
