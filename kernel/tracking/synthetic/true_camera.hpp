// SPDX-License-Identifier: GPL-3.0-or-later
// A camera as it is, not as tracking takes it to be: more distortion than a solver knows, a blur, a sensor with faults.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking::synthetic {

/// Brown's distortion [Brown1971] with thin-prism terms [Weng1992] in OpenCV's form: s1 r^2 + s2 r^4 is added to x',
/// s3 r^2 + s4 r^4 to y'. No solver of this project has the latter.
struct TrueLens {
    double fx = 0.0;  ///< [pixels]
    double fy = 0.0;
    double cx = 0.0;
    double cy = 0.0;
    double k1 = 0.0;
    double k2 = 0.0;
    double p1 = 0.0;
    double p2 = 0.0;
    double k3 = 0.0;
    std::array<double, 4> s{};
};

/// What lens and ring light do to brightness and sharpness.
struct Optics {
    double psf_px = 0.55;       ///< standard deviation of the blur on the axis, in focus [pixels]
    double psf_rim_px = 0.2;    ///< what is added to it in the image's corner, as the square of the radius
    double focus_mm = 450.0;    ///< depth of best focus
    double defocus_px = 400.0;  ///< further blur, added in squares, for |1/depth - 1/focus| [pixels mm]
    double vignetting = 0.35;   ///< share of light that is lost where |(x, y)| is `vignetting_at`
    double vignetting_at = 0.5;
};

struct HotPixel {
    int x = 0;
    int y = 0;
    double light = 0.0;  ///< [digital numbers]
};

/// 8 bits. Digital numbers (DN) throughout.
struct Sensor {
    double black = 4.0;
    double electrons = 40.0;         ///< for each DN
    double read_noise = 1.5;         ///< standard deviation [DN], 0 to 7
    double fixed_pattern = 0.3;      ///< of the black level from pixel to pixel, standard deviation [DN]
    double response_spread = 0.005;  ///< of sensitivity from pixel to pixel, standard deviation
    std::vector<HotPixel> hot{};
};

struct TrueCamera {
    std::string name{};
    int width = 0;  ///< [pixels]
    int height = 0;
    TrueLens lens{};
    Pose pose{};  ///< as tracking's Camera has it
    Optics optics{};
    Sensor sensor{};
    double time_offset_s = 0.0;  ///< it exposes that much later than it says
};

/// The image of a direction (X/Z, Y/Z) [pixels].
Vec2 distorted(const TrueLens& lens, const Vec2& direction);

/// d pixel / d direction [pixels].
Mat2 distortion_slope(const TrueLens& lens, const Vec2& direction);

/// The direction of a pixel, to 1e-12 within the image.
Vec2 undistorted(const TrueLens& lens, const Vec2& pixel);

/// The image of a point of the rig [pixels], perhaps outside the image; none: it is behind the camera.
std::optional<Vec2> project(const TrueCamera& camera, const Vec3& point);

/// Standard deviation of the blur of what is at a pixel, `depth_mm` before the camera; 0.5 to 0.9 pixels.
double psf_sigma(const TrueCamera& camera, const Vec2& pixel, double depth_mm);

/// Share of light that comes through in a direction: 1 on the axis.
double sensitivity(const Optics& optics, const Vec2& direction);
/// Its derivative by the direction, divided by itself.
Vec2 sensitivity_slope(const Optics& optics, const Vec2& direction);

}  // namespace rhexis::tracking::synthetic
