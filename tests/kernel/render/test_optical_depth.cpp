// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "scenes/exact_depth.hpp"
#include "scenes/pictures.hpp"
#include "support/sanitized.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = sanitized ? 120 : 240;
constexpr int height = sanitized ? 90 : 180;

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
    const View view = frame.eye && frame.eye->has_cornea ? view_through_cornea(camera, width, height, *frame.eye)
                                                         : view_in_air(camera, width, height);
    const ExactDepth exact = exact_depth(frame, view);
    return compare(picture, exact);
}

void check_gates(const DepthError& error) {
    INFO("rms " << error.rms << ", largest " << error.largest << ", compared " << error.compared << ", largest depth "
                << error.largest_tau);
    CHECK(error.compared > width * height / 5);
    CHECK(error.largest_tau > 0.3);
    CHECK(error.rms < 1e-6);
    CHECK(error.largest < 1e-5);
}

}  // namespace

TEST_CASE("The optical depth of a whole lens behind its cornea is that of exact ray casting" *
          doctest::skip(sanitized)) {
    check_gates(error_of(patient_frame(3.0), near_camera()));
}

TEST_CASE("Without a cornea, nothing bends the light on its way to the lens" * doctest::skip(sanitized)) {
    Frame frame = patient_frame(3.0);
    std::shared_ptr<EyeAnatomy> eye = std::make_shared<EyeAnatomy>(*frame.eye);
    eye->has_cornea = false;
    frame.eye = std::move(eye);
    check_gates(error_of(frame, near_camera()));
}

TEST_CASE("The optical depth of a grooved lens with the instrument inside is that of exact ray casting") {
    Frame frame = patient_frame(4.0);
    carve_groove(frame.model->solids[0], frame.solids[0], 0.6, -2.5, 2.0, 0.3);
    for (std::size_t t = 0; t < frame.solids[0].fraction.size(); t += 97) {
        frame.solids[0].fraction[t] *= 0.6;
    }
    frame.tools[0].present = true;
    frame.tools[0].pose = hand_pose(Vec3(0.1, 1.0, 0.2), 0.6);
    check_gates(error_of(frame, near_camera()));
}

TEST_CASE("The optical depth of a bare lens seen from the side is that of exact ray casting" *
          doctest::skip(sanitized)) {
    Frame frame = patient_frame(3.0);
    frame.eye.reset();
    Camera camera;
    camera.eye = Vec3(10.0, -15.0, 8.0);
    camera.up = Vec3::UnitZ();
    camera.field_mm = 7.0;
    carve_groove(frame.model->solids[0], frame.solids[0], 0.5, -3.0, 3.0, -0.5);
    check_gates(error_of(frame, camera));
}

TEST_CASE("A lens-shaped body darkens as Beer and Lambert say, within 1 % beyond its faceting") {
    const HalfEllipsoids shape{4.6, 2.1, 2.1};
    const double extinction = 0.2;
    const Frame frame = frame_of(lens_body(shape, 24000), Vec3::Constant(extinction), false);
    Camera camera;
    camera.field_mm = 8.0;
    Renderer renderer = std::move(Renderer::create(width, height)).value();
    const OpticalDepth picture = renderer.optical_depth(frame, camera);
    const View view = view_in_air(camera, width, height);
    // A mesh inscribed in a smooth shape is smaller: its lengths are compared per volume.
    const double faceting = mesh_volume(frame.model->solids[0].coarse) / shape_volume(shape);
    CHECK(faceting > 0.97);
    CHECK(faceting < 1.0);
    double worst = 0.0;
    for (int y = 0; y < height; y += 3) {
        for (int x = 0; x < width; x += 3) {
            const Ray ray = pixel_ray(view, x, y);
            const Vec3 scale(1.0 / shape.radius, 1.0 / shape.radius, 1.0 / shape.anterior);
            const Vec3 o = ray.at_plane.cwiseProduct(scale);
            const Vec3 v = ray.direction.cwiseProduct(scale);
            const double square = o.dot(v) * o.dot(v) - v.squaredNorm() * (o.squaredNorm() - 1.0);
            if (square < 0.3 * v.squaredNorm()) {
                continue;  // near the rim, where facets are seen edge-on
            }
            const double length = 2.0 * std::sqrt(square) / v.squaredNorm();
            const double expected = std::exp(-extinction * length * faceting);
            const double drawn = std::exp(-picture.tau[3 * (static_cast<std::size_t>(y) * width + x)]);
            worst = std::max(worst, std::abs(drawn / expected - 1.0));
        }
    }
    INFO("faceting " << faceting << ", worst " << worst);
    CHECK(worst < 0.01);
}

TEST_CASE("Tissues that absorb in different proportions are drawn in three channels, and as exactly" *
          doctest::skip(sanitized)) {
    Frame frame = patient_frame(3.0);
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*frame.model);
    model->solids[0].materials[0].extinction = Vec3(0.10, 0.35, 0.20);
    frame.model = std::move(model);
    check_gates(error_of(frame, near_camera()));
}
