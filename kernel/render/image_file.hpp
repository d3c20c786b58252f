// SPDX-License-Identifier: GPL-3.0-or-later
// Image and video files. Files appear under their name only when they are whole.
#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

Status write_png(const Image& image, const std::string& path);

class VideoFile {
public:
    /// H.264 or MPEG-4 in MP4, whatever this machine encodes; the error names path and codec.
    static Result<VideoFile> create(const std::string& path, int width, int height, double frames_per_second);
    ~VideoFile();
    VideoFile(VideoFile&&) noexcept;
    Status add(const Image& image);
    Status finish();

private:
    struct Parts;
    explicit VideoFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
