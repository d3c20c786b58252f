// SPDX-License-Identifier: GPL-3.0-or-later
#include "video/video_file.hpp"

extern "C" [[gnu::visibility("default")]] void rhexis_create_video(
    const std::string& path, int width, int height, double frames_per_second,
    rhexis::Result<std::unique_ptr<rhexis::Video>>& video) {
    video = rhexis::create_video_file(path, width, height, frames_per_second);
}
