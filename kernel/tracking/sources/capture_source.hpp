// SPDX-License-Identifier: GPL-3.0-or-later
// Exposures from video devices or video files, through OpenCV.
#pragma once

#include "tracking/rig.hpp"
#include "tracking/sources/frame_source.hpp"

namespace rhexis::tracking {

struct CapturePlan {
    std::vector<std::string> of{};  ///< by camera: "0", "1", ... a device (V4L2), or a file
    double rate_hz = 120.0;         ///< at which devices are asked to run; files have their own
};

/// Devices have been tried with none: the code is that of files. All cameras are told to take an exposure before any is
/// read, which holds them together as far as they start together; cameras with a common trigger do better. Exposures of
/// a file that ends before the others are lost; it is over when all are. The error names the camera that is not there,
/// gives images of another size, or was filmed at another rate than those before; one that gives no more ends it.
Result<std::unique_ptr<FrameSource>> open_capture(const CapturePlan& plan, const Rig& rig);

}  // namespace rhexis::tracking
