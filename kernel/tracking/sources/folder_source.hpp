// SPDX-License-Identifier: GPL-3.0-or-later
// Exposures from images on disk: a folder for each camera, named as the camera is, whose images are taken in the order
// of their names.
#pragma once

#include "tracking/rig.hpp"
#include "tracking/sources/frame_source.hpp"

namespace rhexis::tracking {

struct FolderPlan {
    std::string path{};      ///< holds a folder for each camera
    double rate_hz = 120.0;  ///< at which the images were taken
};

/// A number at the end of an image's name says which exposure it is ("000017.png"); where a camera lacks one, that
/// exposure is lost. The error: no such folder, no images, one whose size is not its camera's; all names are looked at
/// before anything is read.
Result<std::unique_ptr<FrameSource>> open_folder(const FolderPlan& plan, const Rig& rig);

/// Writes exposures as open_folder() reads them, "FOLDER/CAMERA/000017.png". Makes the folders.
Status keep_frames(const std::string& folder, const Rig& rig, const FrameSet& set, std::uint64_t number);

}  // namespace rhexis::tracking
