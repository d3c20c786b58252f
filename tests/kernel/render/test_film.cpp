// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "make_renderer.hpp"
#include "scenes/picture_statistics.hpp"
#include "scenes/pictures.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

// As docs/picture.md has them.
const Vec3 lamp(1.53, 1.47, 1.29);
constexpr double half_at_mm = 7.75;
constexpr double mid_grey = 0.20;
constexpr double film_contrast = 1.65;
constexpr double saturation = 1.04;
constexpr double knee = 0.80;

/// What a card of this reflectance shows so far from the middle of the spot, 0 to 255.
Vec3 expected(double reflectance, double beside_mm) {
    const Vec3 light = reflectance * std::exp2(-std::pow(beside_mm / half_at_mm, 4.0)) * lamp;
    const double level = light.dot(Vec3(0.2126, 0.7152, 0.0722));
    Vec3 shown;
    for (int c = 0; c < 3; ++c) {
        double value = (level + saturation * (light[c] - level)) * std::pow(level / mid_grey, film_contrast - 1.0);
        const double over = std::max(value - knee, 0.0);
        value = std::min(value, knee) + (1.0 - knee) * over / (1.0 - knee + over);
        shown[c] = 255.0 * std::pow(value, 1.0 / 2.2);
    }
    return shown;
}

}  // namespace

TEST_CASE("A grey card comes out at three places as the constants of lamp and film say") {
    constexpr int width = 640;
    constexpr int height = 480;
    Renderer renderer = make_renderer(width, height);
    const Frame frame = patient_frame(3.0, 7.5, 500);
    const Camera camera = microscope_camera(frame);
    // perspective: the limbus lies a little nearer than the pupil, where the field is measured
    const double away = camera.eye.z() - frame.eye->limbus_z;
    const double mm_per_pixel = camera.field_mm / height * away / (camera.eye.z() - camera.target.z());
    for (const double reflectance : {0.09, 0.18, 0.36}) {
        const Image image = renderer.photograph_card(reflectance, frame, camera);
        for (const int right_of_middle : {0, 140, 250}) {
            const Vec3 wanted = expected(reflectance, (right_of_middle + 0.5) * mm_per_pixel);
            const std::size_t pixel = static_cast<std::size_t>(height / 2) * width + width / 2 + right_of_middle;
            for (int c = 0; c < 3; ++c) {
                CAPTURE(reflectance);
                CAPTURE(right_of_middle);
                CHECK(image.rgb[3 * pixel + c] == doctest::Approx(wanted[c]).epsilon(0.01).scale(100.0));
            }
        }
    }
}

TEST_CASE("Twelve statistics: of what is known, and of a patient's eye as frames of operations have them") {
    Image half{200, 100, std::vector<unsigned char>(3 * 200 * 100, 0)};
    for (std::size_t i = 0; i < half.rgb.size(); ++i) {
        half.rgb[i] = (i / 3) % 200 < 100 ? 0 : 200;
    }
    const Statistics known = statistics_of(half);
    CHECK(known[1] == doctest::Approx(100.0).epsilon(0.02));  // mean
    CHECK(known[2] == doctest::Approx(100.0).epsilon(0.02));  // deviation
    CHECK(known[5] == doctest::Approx(0.5).epsilon(0.02));    // darker than 25
    CHECK(known[7] == doctest::Approx(1.0).epsilon(0.02));    // of light, over the mean
    CHECK(known[9] == doctest::Approx(1.0));
    CHECK(known[11] == doctest::Approx(0.0));

    Renderer renderer = make_renderer(640, 480);
    for (const double grade : {2.5, 3.5}) {
        Frame frame = patient_frame(grade, 7.5, 500);
        frame.tools[0].present = true;
        frame.tools[0].pose = hand_pose(Vec3(0.1, 0.9, 1.5), 0.5);
        const Statistics values = statistics_of(square_of_field(renderer.draw(frame, microscope_camera(frame))));
        INFO("grade " << grade << ": " << outside_of(values));
        CHECK(count_within(values) >= 10);
    }
}
