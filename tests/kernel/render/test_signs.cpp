// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "make_renderer.hpp"
#include "scenes/sign_frames.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 640;
constexpr int height = 480;
constexpr double clear_share = 0.25;  ///< of the largest difference: a pixel that shows the sign

double luma(const Image& image, std::size_t pixel) {
    const unsigned char* rgb = &image.rgb[3 * pixel];
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// How much a sign stands out from what would be there without it: difference over sum, in the mean over its pixels.
double contrast(const Image& with, const Image& without) {
    const std::size_t pixels = with.rgb.size() / 3;
    double largest = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
        largest = std::max(largest, std::abs(luma(with, i) - luma(without, i)));
    }
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double apart = std::abs(luma(with, i) - luma(without, i));
        if (apart > clear_share * largest) {
            sum += apart / (luma(with, i) + luma(without, i));
            ++count;
        }
    }
    return sum / std::max(1, count);
}

}  // namespace

TEST_CASE("Each sign that a surgeon must notice stands out as much as it did under even light") {
    Renderer renderer = make_renderer(width, height);
    for (const Sign& sign : signs()) {
        Camera camera = microscope_camera(sign.with);
        camera.focus_mm = sign.height - camera.target.z();
        const double found = contrast(renderer.draw(sign.with, camera), renderer.draw(sign.without, camera));
        INFO(std::string(sign.name) << ": " << found << ", before " << sign.contrast_before);
        CHECK(found >= sign.contrast_before);
    }
}
