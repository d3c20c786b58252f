// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "render/eyepiece.hpp"

using namespace rhexis;

namespace {

Image white(int width, int height) {
    return {width, height, std::vector<unsigned char>(3 * static_cast<std::size_t>(width * height), 255)};
}

int red(const Image& image, int x, int y) { return image.rgb[3 * static_cast<std::size_t>(y * image.width + x)]; }

}  // namespace

TEST_SUITE("eyepiece") {
    TEST_CASE("the field is round, and dark outside of it") {
        Camera camera;
        camera.field_mm = 10.0;  // 10 pixels per mm
        camera.stop_mm = 8.0;
        Image image = white(140, 100);
        look_through_eyepiece(camera, image);
        CHECK(red(image, 70, 50) == 255);
        CHECK(red(image, 70, 12) == 255);  // 37.5 pixels from the middle
        CHECK(red(image, 70, 8) == 0);     // 41.5
        CHECK(red(image, 107, 50) == 255);
        CHECK(red(image, 112, 50) == 0);
        CHECK(red(image, 0, 0) == 0);
    }

    TEST_CASE("out of focus a step gets as wide as the disc of a point, and nothing gets lighter or darker") {
        Camera camera;
        camera.field_mm = 10.0;
        camera.blur_mm = 2.0;  // 20 pixels: a standard deviation of 5
        Image image = white(100, 100);
        for (int y = 0; y < 100; ++y) {
            for (std::size_t byte = 0; byte < 150; ++byte) {
                image.rgb[300 * static_cast<std::size_t>(y) + byte] = 0;
            }
        }
        look_through_eyepiece(camera, image);
        CHECK(red(image, 20, 50) == 0);
        CHECK(red(image, 80, 50) == 255);
        CHECK(red(image, 49, 50) + red(image, 50, 50) == doctest::Approx(255).epsilon(0.02));
        CHECK(red(image, 54, 50) == doctest::Approx(0.8159 * 255).epsilon(0.02));  // 0.9 deviations
    }

    TEST_CASE("without a stop and in focus the picture stays as it is") {
        Image image = white(16, 16);
        image.rgb[100] = 7;
        const Image before = image;
        look_through_eyepiece(Camera{}, image);
        CHECK(image.rgb == before.rgb);
    }
}
