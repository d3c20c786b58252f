// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "exact_depth.hpp"
#include "scenes.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 240;
constexpr int height = 180;

Frame eye_frame(double grade) {
    Patient patient;
    patient.nuclear_grade = grade;
    return frame_of(make_eye(patient).value());
}

/// Near enough for faces to be larger than pixels.
Camera near_camera() {
    Camera camera;
    camera.field_mm = 7.0;
    return camera;
}

DepthError error_of(const Frame& frame, const Camera& camera) {
    Result<Renderer> renderer = Renderer::create(width, height);
    REQUIRE(renderer.ok());
    const OpticalDepth picture = renderer.value().optical_depth(frame, camera);
    const View view =
        frame.eye ? view_through_cornea(camera, width, height, *frame.eye) : view_in_air(camera, width, height);
    const ExactDepth exact = exact_depth(frame, view);
    return compare(picture, exact, Silhouette(frame, view, exact));
}

void check_gates(const DepthError& error) {
    INFO("rms " << error.rms << ", largest " << error.largest << ", compared " << error.compared << ", silhouette "
                << error.silhouette << ", largest anywhere " << error.largest_anywhere << ", largest depth "
                << error.largest_tau);
    CHECK(error.compared > 9000);
    CHECK(error.largest_tau > 0.3);
    CHECK(error.rms < 1e-5);
    CHECK(error.largest < 3e-4);
    CHECK(error.largest_anywhere < 0.05);
}

}  // namespace

TEST_CASE("The optical depth of a whole lens behind its cornea is that of exact ray casting") {
    check_gates(error_of(eye_frame(3.0), near_camera()));
}

TEST_CASE("The optical depth of a grooved lens with the instrument inside is that of exact ray casting") {
    Frame frame = eye_frame(4.0);
    carve_groove(frame.model->solids[0], frame.solids[0], 0.6, -2.5, 2.0, 0.3);
    for (std::size_t t = 0; t < frame.solids[0].fraction.size(); t += 97) {
        frame.solids[0].fraction[t] *= 0.6;
    }
    frame.tools[0].present = true;
    frame.tools[0].pose = hand_pose(Vec3(0.1, 1.0, 0.2), 0.6);
    check_gates(error_of(frame, near_camera()));
}

TEST_CASE("The optical depth of a bare lens seen from the side is that of exact ray casting") {
    Frame frame = eye_frame(3.0);
    frame.eye.reset();
    Camera camera;
    camera.eye = Vec3(10.0, -15.0, 8.0);
    camera.up = Vec3::UnitZ();
    camera.field_mm = 7.0;
    carve_groove(frame.model->solids[0], frame.solids[0], 0.5, -3.0, 3.0, -0.5);
    check_gates(error_of(frame, camera));
}
