// SPDX-License-Identifier: GPL-3.0-or-later
// Rig, bodies and where images come from, as a file says it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracking/calibration/coverage.hpp"
#include "tracking/camera.hpp"
#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

/// How a lens was found from images of a board.
struct LensFigures {
    int views = 0;                ///< that it was fitted to
    int left_out = 0;             ///< that did not fit
    int without = 0;              ///< images in which no board was found
    double residual_px = 0.0;     ///< root mean square of the distance
    double focal_sigma_px = 0.0;  ///< standard deviation of fx
    Coverage coverage{};          ///< of the image by points
};

struct Rig {
    std::vector<Camera> cameras{};  ///< 2 to 16
    bool calibrated = false;        ///< lenses and poses are measured, not guessed
    /// How each camera's lens was found, in their order; empty: they are guesses, or somebody knows.
    std::vector<LensFigures> lenses{};
};

/// A JSON file, {"cameras": [{"name", "width", "height", "fx", ..., "k3", "position_mm", "orientation_xyzw"}, ...],
/// "calibrated"}; each camera, or none, may have "lens": {"views", "left_out", "without", "residual_px",
/// "focal_sigma_px", "coverage": [points in each cell]}. The error names the file, the camera and the field.
Result<Rig> read_rig(const std::string& path);
Status write_rig(const Rig& rig, const std::string& path);

/// A JSON file per body, {"name", "radius_mm", "markers_mm": [[x, y, z], ...], "tip_mm": [x, y, z], "axis": [x, y, z],
/// "side": [x, y, z]}: the instrument's +z and +x, the second made square to the first.
Result<MarkerBody> read_marker_body(const std::string& path);
/// The same from its text. where: for errors.
Result<MarkerBody> marker_body_of(const std::string& text, const std::string& where);
Status write_marker_body(const MarkerBody& body, const std::string& path);

}  // namespace rhexis::tracking
