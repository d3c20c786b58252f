// SPDX-License-Identifier: GPL-3.0-or-later
// A video that is being written. Its file appears under its name only when it is whole.
#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

class Video {
public:
    Video() = default;
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
    /// Without finish() no file appears.
    virtual ~Video() = default;
    /// Fails if the image has another size than the video.
    virtual Status add(const Image& image) = 0;
    /// Fails if not all images can be read back from the file, as on a full disk. Nothing can be added afterwards.
    virtual Status finish() = 0;
    [[nodiscard]] virtual const std::string& codec() const = 0;  ///< "H.264" or "MPEG-4"
};

}  // namespace rhexis
