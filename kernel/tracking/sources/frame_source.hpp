// SPDX-License-Identifier: GPL-3.0-or-later
// Where exposures come from: cameras, folders of images, the synthetic rig.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "tracking/spot.hpp"

namespace rhexis::tracking {

struct CameraFrame {
    int camera = 0;       ///< index in the rig
    double time_s = 0.0;  ///< middle of the exposure
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels{};  ///< line by line
    std::string from{};                  ///< file that it was read from; empty: from none

    [[nodiscard]] GreyImage view() const { return {pixels.data(), width, height, width}; }
};

/// Exposures of about the same time, at most one of each camera.
struct FrameSet {
    double time_s = 0.0;  ///< of the exposures that were meant
    std::vector<CameraFrame> frames{};
};

class FrameSource {
public:
    virtual ~FrameSource() = default;
    /// The next exposures, into `set`, whose memory is used again; false: there are no more. It waits for cameras. An
    /// error: a camera that gives nothing more, an image that cannot be read or has another size; its name is told.
    virtual Result<bool> next(FrameSet& set) = 0;
    /// Exposures a second [1/s].
    [[nodiscard]] virtual double rate_hz() const = 0;
    /// Exposures that were asked for and did not come, of all cameras.
    [[nodiscard]] virtual std::uint64_t lost() const { return 0; }
};

}  // namespace rhexis::tracking
