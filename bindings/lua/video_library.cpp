// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/video_library.hpp"

#include "base/program.hpp"
#include "video/video_file.hpp"

namespace rhexis {

Result<std::unique_ptr<Video>> open_video(const std::string& path, int width, int height, double frames_per_second) {
    const Result<void*> opened = load_library("rhexis-video.so", "its videos");
    if (!opened) {
        return opened.error();
    }
    Result<std::unique_ptr<Video>> video = std::unique_ptr<Video>();
    entry_of<VideoEntry>(opened.value(), video_entry_name)(path, width, height, frames_per_second, video);
    return video;
}

}  // namespace rhexis
