// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/fitted_renderer.hpp"

#include <SDL.h>
#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <cmath>
#include <cstdlib>

#include "scenes/pictures.hpp"
#include "station/window/read_window.hpp"
#include "station/window/window.hpp"

using namespace rhexis;
using namespace rhexis::station;
using namespace rhexis::testing;

namespace {

/// What the window shows of a frame.
Image shown(const Window& window, FittedRenderer& renderer, const Frame& frame, Stereo stereo = Stereo::off) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window.width(), window.height());
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.show(frame, microscope_camera(frame), {0, 0, window.width(), window.height()}, stereo);
    return read_window(window);
}

/// The same without any window, whose context it leaves.
Image alone(const Frame& frame) { return Renderer::create(320, 240).value().draw(frame, microscope_camera(frame)); }

/// Grey levels between two pictures, in the mean.
double apart(const Image& a, const Image& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    }
    return sum / static_cast<double>(a.rgb.size());
}

bool is_black(const Image& image, int x, int y) {
    const unsigned char* pixel = &image.rgb[3 * (static_cast<std::size_t>(y) * image.width + x)];
    return pixel[0] + pixel[1] + pixel[2] == 0;
}

/// A part of a picture.
Image part(const Image& image, int left, int width) {
    Image result{width, image.height, {}};
    for (int y = 0; y < image.height; ++y) {
        const auto row = image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + left);
        result.rgb.insert(result.rgb.end(), row, row + 3 * static_cast<std::ptrdiff_t>(width));
    }
    return result;
}

}  // namespace

TEST_SUITE("fitted renderer") {
    TEST_CASE("a window that changes its size: the picture keeps its shape, and is drawn anew when that has settled") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        const Image first = alone(frame);
        // where no screen is, the surface keeps the size it began with: this is the larger one
        Result<Window> opened = Window::open("test", 480, 240, false);
        REQUIRE(opened.ok());
        Window& window = opened.value();
        REQUIRE(window.draw_here().ok());
        {
            Result<FittedRenderer> made = FittedRenderer::create(320, 240);
            REQUIRE(made.ok());
            FittedRenderer& renderer = made.value();
            CHECK_FALSE(renderer.fit(320, 240, 1.0, 0.5));
            CHECK_FALSE(renderer.fit(480, 240, 1.0, 1.0));
            const Image meanwhile = shown(window, renderer, frame);
            CHECK(is_black(meanwhile, 40, 120));
            CHECK(apart(part(meanwhile, 80, 320), first) < 1.0);
            CHECK_FALSE(renderer.fit(480, 240, 1.0, 1.2));
            CHECK(renderer.fit(480, 240, 1.0, 1.3));
            CHECK_FALSE(renderer.fit(480, 240, 1.0, 9.0));
            const Image settled = shown(window, renderer, frame);
            CHECK_FALSE(is_black(settled, 40, 120));
            CHECK(apart(part(settled, 80, 320), first) < 1.0);
        }
        window.let_go();
    }

    TEST_CASE("a size that no picture can have leaves the one before; one of nothing is drawn as the least there is") {
        Result<Window> opened = Window::open("test", 160, 120, false);
        REQUIRE(opened.ok());
        Window& window = opened.value();
        REQUIRE(window.draw_here().ok());
        {
            const Frame frame = patient_frame(3.0, 7.5, 1500);
            Result<FittedRenderer> made = FittedRenderer::create(160, 120);
            REQUIRE(made.ok());
            const Image before = shown(window, made.value(), frame);
            CHECK_FALSE(made.value().fit(100000, 120, 1.0, 1.0));
            CHECK_FALSE(made.value().fit(100000, 120, 1.0, 2.0));
            CHECK(made.value().fit(0, 0, 1.0, 3.0) == false);
            CHECK(made.value().fit(0, 0, 1.0, 4.0));
            CHECK(made.value().fit(0, 0, 1.0, 5.0) == false);
            CHECK(made.value().fit(160, 120, 1.0, 6.0) == false);
            CHECK(made.value().fit(160, 120, 1.0, 7.0));
            CHECK(apart(shown(window, made.value(), frame), before) < 0.1);
        }
        window.let_go();
    }

    TEST_CASE("side by side each eye has its half of the window, and its picture is not squeezed") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        const Image one = alone(frame);
        Result<Window> opened = Window::open("test", 640, 240, false);
        REQUIRE(opened.ok());
        Window& window = opened.value();
        REQUIRE(window.draw_here().ok());
        {
            Result<FittedRenderer> made = FittedRenderer::create(320, 240);
            REQUIRE(made.ok());
            const Image both = shown(window, made.value(), frame, Stereo::side_by_side);
            CHECK(apart(part(both, 0, 320), one) < 6.0);  // from 12 mm aside
            CHECK(apart(part(both, 320, 320), one) < 6.0);
        }
        window.let_go();
    }
}
