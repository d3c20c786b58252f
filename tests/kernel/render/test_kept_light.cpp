// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "make_renderer.hpp"
#include "scenes/golden_frames.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int kept_width = 240;
constexpr int kept_height = 180;
constexpr int beside_edges = 3;  ///< of 255: in a few single pixels beside edges of instruments

constexpr int of_a_pixel = 2;  ///< grey levels: light is kept in sixteen bits

int most_apart(const Image& a, const Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        most = std::max(most, std::abs(static_cast<int>(a.rgb[i]) - static_cast<int>(b.rgb[i])));
    }
    return most;
}

}  // namespace

TEST_CASE("kept light looks as light that is drawn anew, while instruments, eye and microscope move") {
    Renderer keeping = make_renderer(kept_width, kept_height, Light::kept);
    Renderer reference = make_renderer(kept_width, kept_height);
    Frame frame = sculpted_frame(3.0, 0.2, true);
    frame.wounds.emplace();
    Camera camera = microscope_camera(frame);
    const auto same = [&](const std::string& what) {
        for (int picture = 0; picture < 3; ++picture) {  // anew, written, drawn from what is kept
            frame.time_s += 0.04;
            const int apart = most_apart(keeping.draw(frame, camera), reference.draw(frame, camera));
            CHECK_MESSAGE(apart <= of_a_pixel, what);
        }
    };
    same("at first");
    for (int i = 0; i < 4; ++i) {  // over the iris, into the pupil, out of the wound
        frame.tools[0].pose.position += Vec3(0.8, -1.1, 0.3);
        same("the instrument moves");
    }
    frame.debris.push_back({});
    frame.debris.back().position = Vec3(0.5, 0.5, 2.6);
    frame.debris.back().volume = 0.1;
    same("a crumb");
    const auto eye = std::make_shared<EyeAnatomy>(*frame.eye);
    eye->incision_width = 2.4;
    frame.eye = eye;
    frame.wounds->wounds[main_wound].cut = true;
    frame.wounds->wounds[main_wound].inner = eye->incision;
    frame.wounds->wounds[main_wound].fluid = 3.0;
    frame.wounds->wounds[main_wound].sutures = 2;
    same("the wound leaks");
    frame.prolapse.emplace();
    frame.prolapse->length = 2.0;
    same("iris comes out");
    camera.target += Vec3(0.7, 0.2, 0.0);
    camera.eye += Vec3(0.7, 0.2, 0.0);
    same("the microscope moves");
    camera.light = 0.6;
    same("the lamp is turned down");
    eye->pupil_radius -= 0.6;
    same("the pupil comes in");
    eye->wound_burn = 0.8;
    same("the wound is burnt");
}

TEST_CASE("every golden picture looks the same from kept light") {
    Renderer keeping = make_renderer(kept_width, kept_height, Light::kept);
    Renderer reference = make_renderer(kept_width, kept_height);
    for (const GoldenFrame& one : golden_frames()) {
        const Camera camera = microscope_camera(one.frame);
        keeping.draw(one.frame, camera);
        keeping.draw(one.frame, camera);
        CHECK_MESSAGE(most_apart(keeping.draw(one.frame, camera), reference.draw(one.frame, camera)) <= of_a_pixel,
                      one.name);
    }
}

TEST_CASE(
    "kept light looks as light that is drawn anew through a microscope, however far instruments are out of focus") {
    Renderer keeping = make_renderer(kept_width, kept_height, Light::kept);
    Renderer reference = make_renderer(kept_width, kept_height);
    Frame frame = sculpted_frame(3.0, 0.2, true);
    const Camera camera = microscope_camera_through(frame);
    const Vec3 low = frame.tools[0].pose.position;
    for (const double height : {0.0, 0.0, 0.0, 9.0, 9.0, 4.0, 0.0, 12.0, 12.0, 0.5}) {
        frame.time_s += 0.04;
        frame.tools[0].pose.position = low + Vec3(0.1 * height, 0.0, height);
        INFO(height << " mm up");
        CHECK(most_apart(keeping.draw(frame, camera), reference.draw(frame, camera)) <= of_a_pixel);
    }
}

TEST_CASE("a picture that is drawn anew does not depend on what was drawn before it") {
    Renderer used = make_renderer(kept_width, kept_height);
    Frame frame = sculpted_frame(3.0, 0.2, true);
    for (const bool through : {false, true}) {
        Camera camera = through ? microscope_camera_through(frame) : microscope_camera(frame);
        for (const double zoom : {0.3, 1.6, 0.6, 1.0}) {
            Camera zoomed = camera;
            zoomed.field_mm *= zoom;
            frame.tools[0].pose.position.z() += zoom < 0.5 ? 6.0 : -1.0;
            CHECK(most_apart(used.draw(frame, zoomed), make_renderer(kept_width, kept_height).draw(frame, zoomed)) <=
                  beside_edges);
        }
        frame.tools[0].present = false;
        used.draw(frame, camera);
        frame.tools[0].present = true;
    }
}
