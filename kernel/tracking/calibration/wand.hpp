// SPDX-License-Identifier: GPL-3.0-or-later
// Where cameras stand, from a wand waved before them: a straight bar with two or three spheres of known distance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "tracking/rig.hpp"

namespace rhexis::tracking {

struct Wand {
    /// Where the centres of its spheres lie along it [mm], rising: 2 or 3. The gaps between three differ by a quarter
    /// at least.
    std::vector<double> at_mm{};
    double sigma_mm = 0.01;  ///< standard deviation of the distance between the outer two, as it was measured
    double radius_mm = 0.0;  ///< of its spheres, 0 to 20: the image of one is not about that of its centre

    [[nodiscard]] double length_mm() const { return at_mm.back() - at_mm.front(); }
};

/// What one camera saw of the wand: the spots' centres [pixels], as many as it has spheres, in any order.
struct WandView {
    int camera = 0;  ///< index in the rig
    std::vector<Vec2> spots{};
};

/// One exposure; a camera that did not see all spheres has no view, or one that is left out.
struct WandFrame {
    std::vector<WandView> views{};
};

enum class RigFrame : std::uint8_t {
    first_camera,  ///< the first camera keeps the pose that it was given
    nominal,       ///< the cameras lie as near to where they were given as a rigid motion brings them [Umeyama1991]
};

struct WandSettings {
    RigFrame frame = RigFrame::nominal;
    bool refine_lenses = false;    ///< all of each lens but k3, which the wand hardly determines
    double spot_sigma_px = 0.05;   ///< standard deviation of a spot's centre
    double bending_mm = 0.02;      ///< standard deviation of the wand's length between frames
    int fewest_frames = 50;        ///< that are needed
    int fewest_shared_frames = 8;  ///< that link two cameras
    int most_iterations = 50;      ///< of one adjustment
};

/// What is known of one camera after the adjustment.
struct WandCamera {
    int views = 0;                   ///< that were fitted
    double residual_px = 0.0;        ///< root mean square over both coordinates of all spots
    double position_sigma_mm = 0.0;  ///< of its place, standard deviation in the frame of the first camera, whose is 0
};

struct WandCalibration {
    Rig rig{};
    std::vector<WandCamera> cameras{};
    double residual_px = 0.0;  ///< root mean square over all
    double scale_sigma = 0.0;  ///< standard deviation of the scale, as a share: 1e-4 is 0.01 %
    int frames_used = 0;
    int frames_dropped = 0;  ///< that at least two cameras saw, but that do not fit
    int iterations = 0;      ///< of all adjustments
    double seconds = 0.0;    ///< of one processor, that all of it took
};

/// Poses of a rig's cameras, whose lenses are known. Essential matrices between pairs [Nister2004], scaled by the wand,
/// are the start of a bundle adjustment [Triggs2000] over poses, the wand's places and its length. Standard deviations
/// are those of the adjustment's covariance, times the residual over the one that was expected, where that is greater.
///
/// Which spot is which: three by the gaps between them, so the rig's poses may be anything, and once more by the poses
/// that were found. Two by what the poses that
/// were given make of it: those have to be right to about 5 degrees and a tenth of the distance to the wand.
///
/// The error says which camera never sees the wand, which groups of cameras share no frames, that there are too few
/// frames, what is wrong with the wand, or that the adjustment did not converge. Lenses and sizes are taken from the
/// rig that is given.
Result<WandCalibration> calibrate_wand(const Rig& given, const Wand& wand, std::span<const WandFrame> frames,
                                       const WandSettings& settings = {});

}  // namespace rhexis::tracking
