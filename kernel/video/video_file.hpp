// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "video/video.hpp"

namespace rhexis {

/// H.264 or MPEG-4 in MP4, whatever this machine encodes; the error names path and codec.
/// width, height: 16 to 4096, even; path ends in .mp4; 1 to 240 frames per second.
Result<std::unique_ptr<Video>> create_video_file(const std::string& path, int width, int height,
                                                 double frames_per_second);

/// The same by a shared object, which shows this function.
inline constexpr const char* video_entry_name = "rhexis_create_video";
using VideoEntry = void(const std::string& path, int width, int height, double frames_per_second,
                        Result<std::unique_ptr<Video>>& video);

}  // namespace rhexis
