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

/// Open, and drawn in on this thread; of what is drawn with, the last to go.
struct DrawnWindow {
    DrawnWindow(int width, int height) : opened(Window::open("test", width, height, false)) {
        REQUIRE(opened.ok());
        REQUIRE(opened.value().draw_here().ok());
    }
    ~DrawnWindow() { opened.value().let_go(); }
    DrawnWindow(const DrawnWindow&) = delete;
    DrawnWindow& operator=(const DrawnWindow&) = delete;

    Result<Window> opened;
    Window& window = opened.value();
};

FittedRenderer fitted(int width, int height) {
    Result<FittedRenderer> made = FittedRenderer::create(width, height);
    REQUIRE(made.ok());
    return std::move(made).value();
}

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
        const DrawnWindow larger(480, 240);
        FittedRenderer renderer = fitted(320, 240);
        CHECK_FALSE(renderer.fit(320, 240, 1.0, 0.5));
        CHECK_FALSE(renderer.fit(480, 240, 1.0, 1.0));
        const Image meanwhile = shown(larger.window, renderer, frame);
        CHECK(is_black(meanwhile, 40, 120));
        CHECK(apart(part(meanwhile, 80, 320), first) < 1.0);
        CHECK_FALSE(renderer.fit(480, 240, 1.0, 1.2));
        CHECK(renderer.fit(480, 240, 1.0, 1.3));
        CHECK_FALSE(renderer.fit(480, 240, 1.0, 9.0));
        const Image settled = shown(larger.window, renderer, frame);
        CHECK_FALSE(is_black(settled, 40, 120));
        CHECK(apart(part(settled, 80, 320), first) < 1.0);
    }

    TEST_CASE("a size that no picture can have leaves the one before; one of nothing is drawn as the least there is") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        const DrawnWindow small(160, 120);
        FittedRenderer renderer = fitted(160, 120);
        const Image before = shown(small.window, renderer, frame);
        CHECK_FALSE(renderer.fit(100000, 120, 1.0, 1.0));
        CHECK_FALSE(renderer.fit(100000, 120, 1.0, 2.0));
        CHECK(apart(shown(small.window, renderer, frame), before) < 0.1);
        CHECK_FALSE(renderer.fit(0, 0, 1.0, 3.0));
        CHECK(renderer.fit(0, 0, 1.0, 4.0));
        CHECK_FALSE(renderer.fit(0, 0, 1.0, 5.0));
        CHECK_FALSE(renderer.fit(160, 120, 1.0, 6.0));
        CHECK(renderer.fit(160, 120, 1.0, 7.0));
        CHECK(apart(shown(small.window, renderer, frame), before) < 0.1);
    }

    TEST_CASE("side by side each eye has its half of the window, and its picture is not squeezed") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        const Image one = alone(frame);
        const DrawnWindow wide(640, 240);
        FittedRenderer renderer = fitted(320, 240);
        const Image both = shown(wide.window, renderer, frame, Stereo::side_by_side);
        CHECK(apart(part(both, 0, 320), one) < 6.0);  // from 12 mm aside
        CHECK(apart(part(both, 320, 320), one) < 6.0);
    }
}
