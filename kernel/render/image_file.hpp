// SPDX-License-Identifier: GPL-3.0-or-later
// Image and video files. Files appear under their name only when they are whole.
#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

/// Fails if the path cannot be written or the disk is full; what was there under that name then stays as it was.
Status write_png(const Image& image, const std::string& path);

class VideoFile {
public:
    /// H.264 or MPEG-4 in MP4, whatever this machine encodes; the error names path and codec.
    /// width, height: 16 to 4096, even; path ends in .mp4.
    static Result<VideoFile> create(const std::string& path, int width, int height, double frames_per_second);
    /// Without finish() no file appears.
    ~VideoFile();
    VideoFile(VideoFile&&) noexcept;
    /// Fails if the image has another size than the video.
    Status add(const Image& image);
    /// Fails if not all images can be read back from the file, as on a full disk. Nothing can be added afterwards.
    Status finish();
    [[nodiscard]] const std::string& codec() const;  ///< "H.264" or "MPEG-4"

private:
    struct Parts;
    explicit VideoFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
