// SPDX-License-Identifier: GPL-3.0-or-later
// What the cameras see and what was made of it, drawn for a person.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flow/frame.hpp"
#include "tracking/calibration/lens_calibration.hpp"
#include "tracking/marker_body.hpp"
#include "tracking/rig.hpp"
#include "tracking/sources/frame_source.hpp"

namespace rhexis::tracking {

/// One exposure of all cameras, as far as they came, and what was made of it. A copy is cheap: images are shared.
struct SeenByCameras {
    std::vector<CameraSpots> exposures{};
    std::shared_ptr<const FrameSet> images{};   ///< null: there are none, only spots
    std::vector<std::optional<Pose>> bodies{};  ///< by body, in the rig; none: it is lost
};

/// Of the body with this number, wherever it is drawn or named: red, green, blue.
std::array<unsigned char, 3> body_colour(std::size_t body);

/// What one camera sees, so many pixels wide and as high as its image then is: the image, or a dark ground; a ring
/// around each spot, a cross where each marker of a body should be, a dot at its tip, a line along its shaft, and
/// names. A camera whose exposure did not come says so. width: 64 to 4096.
Image annotated_camera(const Rig& rig, std::span<const MarkerBody> bodies, const SeenByCameras& seen, int camera,
                       int width);

/// Lights up the cells of a camera's picture that points fell into.
void draw_coverage(const Coverage& coverage, Image& picture);

/// All of them beside each other as a PNG file.
Status write_annotated(const std::string& path, const Rig& rig, std::span<const MarkerBody> bodies,
                       const SeenByCameras& seen);

}  // namespace rhexis::tracking
