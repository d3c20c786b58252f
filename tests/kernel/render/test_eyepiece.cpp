// SPDX-License-Identifier: GPL-3.0-or-later
// The optics of the microscope, and two eyes, on pictures of an eye.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "make_renderer.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"
#include "scenes/pictures.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 320;
constexpr int height = 240;

int red(const Image& image, int x, int y) { return image.rgb[3 * (static_cast<std::size_t>(y) * image.width + x)]; }

/// Through a microscope that is focused so high over the pupil.
Camera focused(const Frame& frame, double focus_mm) {
    Camera camera = microscope_camera(frame);
    camera.aperture = 0.03;
    camera.focus_mm = focus_mm;
    return camera;
}

Camera without_optics(const Frame& frame) {
    Camera camera = microscope_camera(frame);
    camera.aperture = 0.0;
    return camera;
}

/// How sharp a part of the picture is: mean difference of neighbours.
double sharpness(const Image& image, int left, int top, int right, int bottom) {
    double sum = 0.0;
    int count = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x, ++count) {
            const double apart = red(image, x + 1, y) - red(image, x, y);
            sum += apart * apart;
        }
    }
    return std::sqrt(sum / count);
}

double mean(const Image& image) {
    double sum = 0.0;
    for (const unsigned char value : image.rgb) {
        sum += value;
    }
    return sum / static_cast<double>(image.rgb.size());
}

}  // namespace

TEST_SUITE("eyepiece") {
    TEST_CASE("the field is round, and dark outside of it") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        Camera camera = microscope_camera(frame);
        camera.stop_mm = 12.0;
        Renderer renderer = make_renderer(width, height);
        const Image image = renderer.draw(frame, camera);
        const double radius = 6.0 * height / camera.field_mm;
        int lit = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double away = std::hypot(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height);
                if (away > radius + 2.0) {
                    CHECK_MESSAGE(red(image, x, y) == 0, x, " ", y);
                }
                lit += away < radius - 2.0 && red(image, x, y) > 0 ? 1 : 0;
            }
        }
        CHECK(lit > 0.95 * 3.14 * (radius - 2.0) * (radius - 2.0));
    }

    TEST_CASE("what is in focus is as sharp as without optics; the rest spreads, and nothing gets lighter or darker") {
        const Frame frame = patient_frame(3.0, 7.5, 1500);
        Renderer renderer = make_renderer(width, height);
        const Image plain = renderer.draw(frame, without_optics(frame));
        const Image iris = renderer.draw(frame, focused(frame, 0.0));
        const Image high = renderer.draw(frame, focused(frame, 8.0));
        // the pupil's edge, left of the middle
        const int left = static_cast<int>(0.5 * width - 4.5 / 14.6 * height);
        const int right = static_cast<int>(0.5 * width - 3.7 / 14.6 * height);
        const double at_focus = sharpness(iris, left, 110, right, 130);
        CHECK(at_focus == doctest::Approx(sharpness(plain, left, 110, right, 130)).epsilon(0.02));
        CHECK(sharpness(high, left, 110, right, 130) < 0.6 * at_focus);
        CHECK(mean(high) == doctest::Approx(mean(plain)).epsilon(0.05));  // what was blown out spreads
    }

    TEST_CASE("an instrument far over the focus is out of it, and its tip in it") {
        Frame frame = patient_frame(3.0, 7.5, 1500);
        frame.tools[0].present = true;
        frame.tools[0].pose = hand_pose(Vec3(0.0, 0.0, 2.6), 0.0);
        Renderer renderer = make_renderer(width, height);
        Camera plain = without_optics(frame);
        const double at_tip = 2.6 - frame.eye->iris_z;
        const auto row = [&](double y_mm) { return static_cast<int>(0.5 * height - y_mm / plain.field_mm * height); };
        const Image sharp = renderer.draw(frame, plain);
        const Image tip = renderer.draw(frame, focused(frame, at_tip));
        const Image shaft = renderer.draw(frame, focused(frame, at_tip + 5.0));
        const auto around = [&](const Image& image, double y_mm) {
            return sharpness(image, width / 2 - 25, row(y_mm) - 6, width / 2 + 25, row(y_mm) + 6);
        };
        CHECK(around(tip, -1.0) > 0.8 * around(sharp, -1.0));
        CHECK(around(shaft, -1.0) < 0.6 * around(sharp, -1.0));
    }

    TEST_CASE("without a microscope the focus is where the lowest instrument works") {
        Frame frame = patient_frame(3.0, 7.5, 1500);
        const auto focus = [&] { return microscope_camera(frame).focus_mm + frame.eye->iris_z; };
        CHECK(focus() == doctest::Approx(frame.eye->iris_z - 1.0));
        frame.tools[0].present = true;
        for (const auto& [tip, wanted] : {std::pair(9.0, frame.eye->iris_z - 1.0), std::pair(-1.0, -1.0),
                                          std::pair(-2.0, -2.0), std::pair(-30.0, frame.eye->iris_z - 4.5)}) {
            frame.tools[0].pose.position.z() = tip;
            CHECK(std::abs(focus() - wanted) <= 0.125);
        }
    }

    TEST_CASE("a shaft that is bent off its end is as high as it is drawn") {
        Frame frame = patient_frame(3.0, 7.5, 1500);
        std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*frame.model);
        model->tools = {make_tool("cystotome").value()};
        frame.model = model;
        frame.tools[0].present = true;
        frame.tools[0].pose.position = Vec3(0.0, 1.0, 2.6);
        const RoundedCone& shaft = model->tools[0].parts[1];
        const Vec3 from = frame.tools[0].pose.to_world(shaft.a);
        const Vec3 way = frame.tools[0].pose.to_world(shaft.b) - from;
        const Vec3 place = from + 4.0 * way.normalized();
        Renderer renderer = make_renderer(width, height);
        const Camera plain = without_optics(frame);
        const auto around = [&](const Image& image) {
            const Vec2 pixel = pixel_of(view_in_air(plain, width, height), place);
            const int x = static_cast<int>(pixel.x());
            const int y = static_cast<int>(pixel.y());
            return sharpness(image, x - 8, y - 4, x + 8, y + 4);
        };
        const double sharp = around(renderer.draw(frame, plain));
        CHECK(around(renderer.draw(frame, focused(frame, place.z() - frame.eye->iris_z))) > 0.8 * sharp);
        CHECK(around(renderer.draw(frame, focused(frame, place.z() - frame.eye->iris_z - 12.0))) < 0.7 * sharp);
    }

    TEST_CASE("the lamp goes with the microscope: the reflex fades beside its middle; and is turned down") {
        const Frame frame = patient_frame(2.0, 7.5, 1500);
        Renderer renderer = make_renderer(width, height);
        const auto reflex = [&](const Camera& camera, double beside_mm) {
            const Image image = renderer.draw(frame, camera);
            return red(image, static_cast<int>(0.5 * width - beside_mm / camera.field_mm * height), height / 2 + 20);
        };
        const Camera centred = microscope_camera(frame);
        Camera beside = centred;
        beside.target.x() += 4.0;
        beside.eye.x() += 4.0;
        Camera dim = centred;
        dim.light = 0.5;
        CHECK(reflex(beside, 4.0) < 0.95 * reflex(centred, 0.0));
        // as the film shows half of a dim light
        CHECK(reflex(dim, 0.0) == doctest::Approx(std::pow(0.5, 1.65 / 2.2) * reflex(centred, 0.0)).epsilon(0.03));
    }

    TEST_CASE("two eyes: at the target nothing is shifted, what is nearer lies before the screen, nothing is turned") {
        Camera camera;
        camera.eye = Vec3(0.0, 0.0, 200.0);
        Camera left = camera;
        left.aside_mm = -0.5 * stereo_base_mm;
        Camera right = camera;
        right.aside_mm = 0.5 * stereo_base_mm;
        const EyeAnatomy eye;
        const View left_view = view_in_air(left, width, height);
        const View right_view = view_in_air(right, width, height);
        const auto parallax = [&](const Vec3& place) {  // of the right picture against the left one
            return (pixel_of(right_view, place) - pixel_of(left_view, place)).eval();
        };
        for (const Vec3& place : {Vec3(0.0, 0.0, 0.0), Vec3(5.0, -4.0, 0.0), Vec3(-6.0, 3.0, 0.0)}) {
            CHECK(parallax(place).norm() < 1e-9);
        }
        for (const Vec3& across : {Vec3(0.0, 0.0, 0.0), Vec3(5.0, -4.0, 0.0)}) {
            const Vec2 nearer = parallax(across + Vec3(0.0, 0.0, 3.0));
            const Vec2 deeper = parallax(across - Vec3(0.0, 0.0, 3.0));
            CHECK(nearer.x() < -0.1);  // to the left in the right eye's picture: crossed, before the screen
            CHECK(deeper.x() > 0.1);
            CHECK(std::abs(nearer.y()) < 1e-9);  // eyes that toed in would see one higher than the other
            CHECK(std::abs(deeper.y()) < 1e-9);
        }
        // base * z / (D - z), in pixels
        const double mm = -parallax(Vec3(0.0, 0.0, 3.0)).x() * camera.field_mm / height;
        CHECK(mm == doctest::Approx(stereo_base_mm * 3.0 / 197.0).epsilon(1e-6));
    }
}
