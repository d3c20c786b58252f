// SPDX-License-Identifier: GPL-3.0-or-later
// Videos, by the shared object that has their libraries: it is loaded with the first one.
#pragma once

#include "video/video.hpp"

namespace rhexis {

/// As create_video_file(); the error is also that of a shared object that is not there.
Result<std::unique_ptr<Video>> open_video(const std::string& path, int width, int height, double frames_per_second);

}  // namespace rhexis
