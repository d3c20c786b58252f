// SPDX-License-Identifier: GPL-3.0-or-later
// Six cameras around an eye, drawn by seed: what a builder would write of them, and what they are.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "tracking/rig.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

/// Standard deviations of what is drawn; all may be 0: then the cameras are what the nominal rig says.
struct RigSpread {
    double position_mm = 3.0;  ///< on each axis
    double turn = 0.01;        ///< about each axis [rad]
    double focal_share = 0.004;
    double centre_px = 6.0;
    double distortion = 1.0;  ///< times a lens's usual k1 k2 p1 p2 k3 s1..s4
    double time_offset_s = 10e-6;
};

struct RigOptions {
    int cameras = 6;             ///< 2 to 16
    double distance_mm = 450.0;  ///< from the origin, 100 to 2000
    int width = 1280;            ///< [pixels], 64 to 4096
    int height = 1024;
    double focal_px = 1667.0;  ///< 100 to 1e5
    int hot_pixels = 5;        ///< of each camera, 0 to 1000
    RigSpread spread{};
    Optics optics{};  ///< each camera's blur on the axis is drawn within 0.05 pixels of it, where spread.distortion > 0
    Sensor sensor{};  ///< without hot pixels, which are drawn
};

/// The origin is the eye, +z up to the microscope. The cameras stand in a ring, by turns 30 and 45 degrees above the
/// eye, which leaves the microscope's axis free, and look at the origin.
struct SyntheticRig {
    Rig nominal{};  ///< as a builder would write it; not calibrated
    std::vector<TrueCamera>
        cameras{};  ///< in the same order. Only for rendering and for who scores: never for a tracker

    /// The same for the same seed. The error names the option that is out of range.
    static Result<SyntheticRig> create(std::uint64_t seed, const RigOptions& options = {});
};

/// The rig that a perfect calibration would give: the true cameras without their thin-prism terms.
Rig without_prism(const SyntheticRig& rig);

}  // namespace rhexis::tracking::synthetic
