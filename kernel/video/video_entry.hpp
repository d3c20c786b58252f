// SPDX-License-Identifier: GPL-3.0-or-later
// What the shared object with video files shows of itself.
#pragma once

#include "video/video.hpp"

namespace rhexis {

inline constexpr const char* video_entry_name = "rhexis_create_video";
using VideoEntry = void(const std::string& path, int width, int height, double frames_per_second,
                        Result<std::unique_ptr<Video>>& video);

}  // namespace rhexis
