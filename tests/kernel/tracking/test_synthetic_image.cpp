// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <opencv2/calib3d.hpp>

#include <numbers>

#include "base/hash.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "support/sanitized.hpp"
#include "synthetic_support.hpp"
#include "tracking/synthetic/window_rays.hpp"

namespace rhexis::tracking::synthetic {
namespace {

std::uint64_t hash_of(const Image& image) {
    StateHash hash;
    hash.add_bytes(image.pixels.data(), image.pixels.size());
    return hash.value();
}

/// A sheet whose edge is straight over a sphere and goes through its middle, as the camera at the origin sees it.
Disc half_sheet(const Vec3& sphere, double turn) {
    constexpr double radius = 4000.0;
    const Vec3 middle = (1.0 - 6.0 / sphere.norm()) * sphere;
    Disc disc;
    disc.normal = sphere.normalized();
    const Vec3 across = disc.normal.unitOrthogonal();
    disc.centre = middle + radius * (std::cos(turn) * across + std::sin(turn) * disc.normal.cross(across));
    disc.radius = radius;
    disc.soft = 0.02;
    return disc;
}

/// Variance of noise from two images of the same light.
double noise_variance(const Image& one, const Image& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        const double apart = static_cast<double>(one.pixels[i]) - static_cast<double>(other.pixels[i]);
        sum += 0.5 * apart * apart;
    }
    return sum / static_cast<double>(one.pixels.size());
}

double mean_of(const Image& image) {
    double sum = 0.0;
    for (const std::uint8_t pixel : image.pixels) {
        sum += pixel;
    }
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("a true camera bends light as OpenCV does with thin-prism terms, and back") {
    const SyntheticRig rig = SyntheticRig::create(3).value();
    Rng rng(1);
    for (const TrueCamera& camera : rig.cameras) {
        const TrueLens& lens = camera.lens;
        const cv::Matx33d matrix(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
        const std::vector<double> bends{lens.k1, lens.k2, lens.p1,   lens.p2,   lens.k3,   0,
                                        0,       0,       lens.s[0], lens.s[1], lens.s[2], lens.s[3]};
        CHECK(std::abs(lens.s[0]) > 0.0);
        for (int i = 0; i < 40; ++i) {
            const Vec2 pixel = uniform2(rng).cwiseProduct(Vec2(camera.width, camera.height));
            const Vec2 direction = undistorted(lens, pixel);
            CHECK((distorted(lens, direction) - pixel).norm() < 1e-8);
            std::vector<cv::Point2d> theirs;
            cv::projectPoints(std::vector<cv::Point3d>{{direction.x(), direction.y(), 1.0}}, cv::Vec3d(0, 0, 0),
                              cv::Vec3d(0, 0, 0), matrix, bends, theirs);
            CHECK((Vec2(theirs[0].x, theirs[0].y) - pixel).norm() < 1e-7);
            constexpr double step = 1e-6;
            const Mat2 slope = distortion_slope(lens, direction);
            for (int j = 0; j < 2; ++j) {
                const Vec2 more = distorted(lens, direction + step * Vec2::Unit(j));
                const Vec2 less = distorted(lens, direction - step * Vec2::Unit(j));
                CHECK((slope.col(j) - (more - less) / (2.0 * step)).norm() < 1e-4);
            }
        }
    }
}

TEST_CASE("rays between a window's knots go through their pixels to a thousandth") {
    const SyntheticRig rig = SyntheticRig::create(4).value();
    for (const TrueCamera& camera : rig.cameras) {
        const Window corner{camera.width - 60, camera.height - 60, camera.width, camera.height};
        const WindowRays rays(camera.lens, corner);
        Rng rng(2);
        for (int i = 0; i < 50; ++i) {
            const Vec2 pixel = Vec2(corner.left, corner.top) + 60.0 * uniform2(rng);
            CHECK((distorted(camera.lens, rays.at(pixel.x(), pixel.y()).head<2>()) - pixel).norm() < 1e-3);
        }
    }
}

TEST_CASE("a rig's cameras are near what a builder writes, not at it, and another seed's are others") {
    const SyntheticRig rig = SyntheticRig::create(5).value();
    const SyntheticRig again = SyntheticRig::create(5).value();
    const SyntheticRig other = SyntheticRig::create(6).value();
    REQUIRE(rig.cameras.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        const std::optional<Vec2> origin = project(rig.cameras[i], Vec3::Zero());
        const std::optional<Vec2> nominal = tracking::project(rig.nominal.cameras[i], Vec3::Zero());
        REQUIRE(origin.has_value());
        REQUIRE(nominal.has_value());
        CHECK((*nominal - Vec2(639.5, 511.5)).norm() < 1e-9);
        CHECK((*origin - *nominal).norm() > 0.5);
        CHECK((*origin - *nominal).norm() < 120.0);
        CHECK(rig.nominal.cameras[i].pose.position.norm() == doctest::Approx(450.0));
        CHECK(rig.cameras[i].lens.fx == again.cameras[i].lens.fx);
        CHECK(rig.cameras[i].lens.fx != other.cameras[i].lens.fx);
        const double up = (rig.nominal.cameras[i].pose.orientation * Vec3::UnitY()).z();
        CHECK(up < 0.0);  // down in the image is down
    }
    RigOptions options;
    options.cameras = 1;
    const Result<SyntheticRig> refused = SyntheticRig::create(1, options);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().text().find("cameras") != std::string::npos);
}

TEST_CASE("a sphere's image is an ellipse whose centre is not the image of the sphere's") {
    for (const double degrees : {10.0, 20.0}) {
        const double tangent = std::tan(degrees * std::numbers::pi / 180.0);
        TrueCamera camera = plain_camera(96, 96);
        RenderScratch scratch;
        Vec2 bias = Vec2::Zero();
        constexpr int places = 16;
        for (int i = 0; i < places; ++i) {
            const Vec3 centre(450.0 * tangent, 0.0, 450.0);
            camera.lens.cx = 48.0 - 1667.0 * tangent + 0.23 * (i % 4);
            camera.lens.cy = 48.0 + 0.23 * (i / 4);
            const Scene scene = one_sphere(centre);
            render_light(camera, {&scene, 1}, 1, scratch);
            bias += (moments_of(scratch.field).mean - *project(camera, centre)) / places;
        }
        const double sine2 = 9.0 / (450.0 * 450.0 * (1.0 + tangent * tangent));
        const double expected = 1667.0 * tangent * (1.0 + tangent * tangent) * sine2;
        CHECK(expected == doctest::Approx(degrees == 10.0 ? 0.0131 : 0.0270).epsilon(0.02));
        CHECK(std::abs(bias.x() - expected) < 0.0015);
        CHECK(std::abs(bias.y()) < 0.0015);
    }
}

TEST_CASE("a sphere that is half hidden has its centre of light 0.42 radii from where it was, a free one has not") {
    const TrueCamera camera = plain_camera(96, 96);
    const Vec3 centre(0.3, -0.4, 450.0);
    const double radius = 1667.0 * 3.0 / 450.0;
    RenderScratch scratch;
    Scene scene = one_sphere(centre);
    render_light(camera, {&scene, 1}, 1, scratch);
    const LightMoments whole = moments_of(scratch.field);
    for (const double turn : {0.3, 2.0, 4.5}) {
        scene.discs = {half_sheet(centre, turn)};
        render_light(camera, {&scene, 1}, 1, scratch);
        const LightMoments half = moments_of(scratch.field);
        CHECK(half.sum == doctest::Approx(0.5 * whole.sum).epsilon(0.01));
        CHECK((half.mean - whole.mean).norm() ==
              doctest::Approx(4.0 / (3.0 * std::numbers::pi) * radius).epsilon(0.01));
        // far behind the sphere it hides nothing
        scene.discs[0].centre *= 2.0;
        render_light(camera, {&scene, 1}, 1, scratch);
        CHECK((moments_of(scratch.field).mean - whole.mean).norm() < 1e-6);
    }
}

TEST_CASE("a marker behind a disc, a rod or another marker leaves no light, beside them all of it") {
    const TrueCamera camera = plain_camera(160, 128);
    const Vec3 centre(1.0, 2.0, 450.0);
    RenderScratch scratch;
    Scene scene = one_sphere(centre);
    render_light(camera, {&scene, 1}, 1, scratch);
    const double whole = moments_of(scratch.field).sum;
    CHECK(whole == doctest::Approx(130.0 * std::numbers::pi * 11.11 * 11.11).epsilon(0.01));
    for (const double aside : {0.0, 14.0}) {
        scene = one_sphere(centre);
        scene.discs = {{Vec3(1.0 + aside, 2.0, 400.0), Vec3::UnitZ(), 6.0, 0.5}};
        render_light(camera, {&scene, 1}, 1, scratch);
        CHECK(moments_of(scratch.field).sum == doctest::Approx(aside > 0.0 ? whole : 0.0).epsilon(1e-5));
        scene.discs.clear();
        scene.capsules = {{Vec3(1.0 + aside, -40.0, 300.0), Vec3(1.0 + aside, 40.0, 300.0), 5.0, 0.5, 0.0}};
        render_light(camera, {&scene, 1}, 1, scratch);
        CHECK(moments_of(scratch.field).sum == doctest::Approx(aside > 0.0 ? whole : 0.0).epsilon(1e-5));
        // a nearer marker that gives no light itself
        scene.capsules.clear();
        scene.spheres.push_back(scene.spheres[0]);
        scene.spheres[1].centre = Vec3(0.8 * (1.0 + aside), 1.6, 360.0);
        scene.spheres[1].light = 0.0;
        render_light(camera, {&scene, 1}, 1, scratch);
        CHECK(moments_of(scratch.field).sum == doctest::Approx(aside > 0.0 ? whole : 0.0).epsilon(1e-5));
    }
}

TEST_CASE("a worn patch takes light where it is, and none when it is on the far side") {
    const TrueCamera camera = plain_camera(96, 96);
    RenderScratch scratch;
    Scene scene = one_sphere({0.0, 0.0, 450.0});
    render_light(camera, {&scene, 1}, 1, scratch);
    const LightMoments whole = moments_of(scratch.field);
    scene.spheres[0].worn_towards = Vec3(1.0, 0.0, -1.0).normalized();
    scene.spheres[0].worn_cosine = 0.8;
    scene.spheres[0].worn_left = 0.4;
    render_light(camera, {&scene, 1}, 1, scratch);
    CHECK(moments_of(scratch.field).mean.x() < whole.mean.x() - 0.5);
    CHECK(moments_of(scratch.field).sum < 0.95 * whole.sum);
    scene.spheres[0].worn_towards = Vec3(1.0, 0.0, 1.0).normalized();
    render_light(camera, {&scene, 1}, 1, scratch);
    CHECK((moments_of(scratch.field).mean - whole.mean).norm() < 1e-6);
}

TEST_CASE("what moves is smeared by its speed times the exposure") {
    const TrueCamera camera = plain_camera(96, 96);
    constexpr double speed_mm_s = 500.0;
    constexpr double exposure_s = 2e-3;
    constexpr int count = 16;
    RenderScratch scratch;
    std::vector<Scene> instants;
    for (int i = 0; i < count; ++i) {
        const double time = exposure_s * ((i + 0.5) / count - 0.5);
        instants.push_back(one_sphere({speed_mm_s * time, 0.0, 450.0}));
    }
    render_light(camera, {instants.data(), 1}, 1, scratch);
    const LightMoments still = moments_of(scratch.field);
    render_light(camera, instants, 1, scratch);
    const LightMoments moving = moments_of(scratch.field);
    const double length = std::sqrt(12.0 * (moving.spread(0, 0) - still.spread(0, 0)));
    CHECK(length == doctest::Approx(1667.0 / 450.0 * speed_mm_s * exposure_s).epsilon(0.01));
    CHECK(moving.spread(1, 1) == doctest::Approx(still.spread(1, 1)).epsilon(1e-3));
    CHECK(moving.sum == doctest::Approx(still.sum).epsilon(1e-3));
    CHECK(std::abs(moving.mean.x() - camera.lens.cx) < 0.005);
}

TEST_CASE("noise has the variance of shot and read noise at every level, lit or dark") {
    TrueCamera camera = plain_camera(256, 256);
    const SensorPattern pattern(camera, 9);
    for (const double level : {2.0, 40.0, 160.0}) {
        const double expected = 1.5 * 1.5 + level / 40.0 + 1.0 / 12.0;
        for (const bool lit : {false, true}) {
            LightField field;
            field.clear(camera.width, camera.height);
            if (lit) {
                field.light.assign(field.light.size(), static_cast<float>(level));
                field.windows.push_back({0, 0, camera.width, camera.height});
            }
            Image one;
            Image other;
            expose(camera.sensor, pattern, field, lit ? 0.0 : level, 1, one);
            expose(camera.sensor, pattern, field, lit ? 0.0 : level, 2, other);
            CHECK(noise_variance(one, other) == doctest::Approx(expected).epsilon(0.03));
            CHECK(mean_of(one) == doctest::Approx(level + 4.0).epsilon(0.01));
            expose(camera.sensor, pattern, field, lit ? 0.0 : level, 1, other);
            CHECK(hash_of(one) == hash_of(other));
        }
    }
}

TEST_CASE("a sensor clips at 255, and its hot pixels are where they are in every image") {
    TrueCamera camera = plain_camera(64, 64);
    camera.sensor.hot = {{20, 30, 90.0}};
    const SensorPattern pattern(camera, 1);
    LightField field;
    field.clear(64, 64);
    field.light[5 * 64 + 5] = 400.0F;
    field.windows.push_back({5, 5, 6, 6});
    Image image;
    for (const std::uint64_t seed : {1U, 2U}) {
        expose(camera.sensor, pattern, field, 3.0, seed, image);
        CHECK(image.pixels[5 * 64 + 5] == 255);
        CHECK(image.pixels[30 * 64 + 20] > 80);
        CHECK(image.pixels[31 * 64 + 20] < 20);
    }
}

TEST_CASE("fingers and handles are dim, dark discs hide them, and glints are seen unless hidden") {
    const TrueCamera camera = plain_camera();
    RenderScratch scratch;
    Scene scene;
    scene.capsules = {{Vec3(-20.0, 0.0, 450.0), Vec3(20.0, 0.0, 450.0), 6.0, 1.0, 10.0}};
    render_light(camera, {&scene, 1}, 1, scratch);
    const LightMoments finger = moments_of(scratch.field);
    const float brightest = *std::max_element(scratch.field.light.begin(), scratch.field.light.end());
    CHECK(brightest < 11.0F);
    CHECK(brightest > 9.0F);
    CHECK((finger.mean - Vec2(camera.lens.cx, camera.lens.cy)).norm() < 0.1);
    scene.discs = {{Vec3(0.0, 0.0, 200.0), Vec3::UnitZ(), 40.0, 1.0}};
    scene.glints = {{Vec3(5.0, 5.0, 450.0), 100.0, 1.0}};
    render_light(camera, {&scene, 1}, 1, scratch);
    CHECK(moments_of(scratch.field).sum == 0.0);
    scene.discs.clear();
    scene.capsules.clear();
    render_light(camera, {&scene, 1}, 1, scratch);
    CHECK((moments_of(scratch.field).mean - *project(camera, {5.0, 5.0, 450.0})).norm() < 0.01);
}

}  // namespace rhexis::tracking::synthetic
