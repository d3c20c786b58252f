// SPDX-License-Identifier: GPL-3.0-or-later
// From an image as OpenCV gives it to a camera's exposure.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "tracking/camera.hpp"
#include "tracking/sources/frame_source.hpp"

namespace rhexis::tracking {

/// The error: another size than the camera's; it names `where`.
Status check_size(int width, int height, const Camera& camera, const std::string& where);

/// Pixels and size of `frame`, of one channel or three, 8 bits each. The error: nothing to read, or another size than
/// the camera's; it names `where`.
Status grey_frame(const cv::Mat& image, const Camera& camera, const std::string& where, CameraFrame& frame);

}  // namespace rhexis::tracking
