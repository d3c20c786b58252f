// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/eyepiece.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rhexis {
namespace {

constexpr double edge_pixels = 2.0;  ///< over which the field gets dark

/// A disc of diameter d has a standard deviation of d / 4 in each direction.
void blur(double diameter_pixels, Image& image) {
    const double deviation = 0.25 * diameter_pixels;
    if (deviation < 0.2) {  // it would change nothing
        return;
    }
    cv::Mat pixels(image.height, image.width, CV_8UC3, image.rgb.data());
    cv::GaussianBlur(pixels, pixels, cv::Size(), deviation, deviation, cv::BORDER_REPLICATE);
}

void stop_field(double radius_pixels, Image& image) {
    std::size_t at = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double across = x + 0.5 - 0.5 * image.width;
            const double up = y + 0.5 - 0.5 * image.height;
            const double inside = (radius_pixels - std::sqrt(across * across + up * up)) / edge_pixels + 0.5;
            const double light = std::clamp(inside, 0.0, 1.0);
            for (int channel = 0; channel < 3; ++channel, ++at) {
                image.rgb[at] = static_cast<unsigned char>(std::lround(light * image.rgb[at]));
            }
        }
    }
}

}  // namespace

void look_through_eyepiece(const Camera& camera, Image& image) {
    const double pixels_per_mm = image.height / camera.field_mm;
    blur(camera.blur_mm * pixels_per_mm, image);
    if (camera.stop_mm > 0.0) {
        stop_field(0.5 * camera.stop_mm * pixels_per_mm, image);
    }
}

}  // namespace rhexis
