// SPDX-License-Identifier: GPL-3.0-or-later
// cameras -> markers: what a camera's image shows of reflecting spheres.
#pragma once

#include <cstdint>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking {

/// 8 bits of infra-red light; a view, which owns nothing.
struct GreyImage {
    const std::uint8_t* pixels = nullptr;
    int width = 0;
    int height = 0;
    int stride = 0;  ///< bytes from a line to the next
};

struct Spot {
    Vec2 at = Vec2::Zero();  ///< centre of its outline [pixels]; the centre of the first pixel is (0, 0)
    double area = 0.0;       ///< of its outline [pixels]
    double roundness = 1.0;  ///< least by greatest semi-axis, or by greatest second moment, root: 1 of a disc
    double sigma_px = 0.0;   ///< standard deviation of `at` each way; 0: its outline was not told apart
    double whole = 1.0;      ///< share of the outline that was
    double peak = 0.0;       ///< brightest pixel, 0 to 255
    bool clipped = false;    ///< several pixels are at 255
    bool at_rim = false;     ///< it touches the image's rim
    bool crowded = false;    ///< another one's light comes so near that the centre is less sure
};

/// One camera's spots of one exposure.
struct CameraSpots {
    int camera = 0;             ///< index in the rig
    double time_s = 0.0;        ///< middle of the exposure, by the tracking computer's clock
    std::vector<Spot> spots{};  ///< in the order in which the image is read
};

}  // namespace rhexis::tracking
