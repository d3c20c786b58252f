// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "base/rng.hpp"
#include "support/sanitized.hpp"
#include "synthetic_support.hpp"
#include "tracking/synthetic/bodies.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/synthetic/marker_spots.hpp"

namespace rhexis::tracking::synthetic {
namespace {

SpotOptions by_light() {
    SpotOptions options;
    options.centre = SpotCentre::light;
    return options;
}

SpotOptions without_noise() {
    SpotOptions options = by_light();
    options.noise = {0.0, 0.0, 0.0};
    return options;
}

/// Without faults of single pixels, but with all of a true camera's lens and blur.
TrueCamera true_lens_camera() {
    RigOptions options;
    options.hot_pixels = 0;
    TrueCamera camera = SyntheticRig::create(11, options).value().cameras[2];
    camera.pose = Pose{};
    camera.sensor.fixed_pattern = 0.0;
    camera.sensor.response_spread = 0.0;
    return camera;
}

/// Spheres all over the view, bright and apart from each other.
Scene spread_spheres() {
    Scene scene;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            Sphere sphere;
            sphere.centre = Vec3(-120.3 + 79.7 * i, -95.1 + 63.9 * j, 420.0 + 15.0 * ((i + j) % 4));
            scene.spheres.push_back(sphere);
        }
    }
    return scene;
}

struct Agreement {
    Vec2 bias = Vec2::Zero();  ///< of images' centroids
    double worst = 0.0;        ///< of one sphere's mean
    double noise = 0.0;        ///< standard deviation on an axis, of images' centroids
};

Agreement agreement_with_images(const TrueCamera& camera, const Scene& scene, int images) {
    const SensorPattern pattern(camera, 3);
    RenderScratch render_scratch;
    SpotScratch scratch;
    std::vector<Spot> spots;
    Rng rng(1);
    spots_without_images(camera, {&scene, 1}, without_noise(), rng, scratch, spots);
    render_light(camera, {&scene, 1}, 1, render_scratch);
    std::vector<Vec2> sums(spots.size(), Vec2::Zero());
    std::vector<double> squares(spots.size(), 0.0);
    Image image;
    for (int i = 0; i < images; ++i) {
        expose(camera.sensor, pattern, render_scratch.field, scene.ambient, static_cast<std::uint64_t>(100 + i), image);
        for (std::size_t j = 0; j < spots.size(); ++j) {
            const double background = camera.sensor.black + scene.ambient;
            const Vec2 off = centroid_near(image, spots[j].at, 19, background, background + 8.0) - spots[j].at;
            sums[j] += off / images;
            squares[j] += off.squaredNorm() / images;
        }
    }
    Agreement result;
    for (std::size_t j = 0; j < spots.size(); ++j) {
        result.bias += sums[j] / static_cast<double>(spots.size());
        result.worst = std::max(result.worst, sums[j].norm());
        result.noise += 0.5 * (squares[j] - sums[j].squaredNorm()) / static_cast<double>(spots.size());
    }
    result.noise = std::sqrt(result.noise);
    return result;
}

/// Outlines of one sphere, of many images or of none: their mean and scatter.
struct Outlines {
    Vec2 mean = Vec2::Zero();
    double scatter_px = 0.0;  ///< each way
    double area = 0.0;
    double roundness = 0.0;
};
Outlines outlines_of(const std::vector<Spot>& spots) {
    Outlines result;
    const auto count = static_cast<double>(spots.size());
    for (const Spot& spot : spots) {
        result.mean += spot.at / count;
        result.area += spot.area / count;
        result.roundness += spot.roundness / count;
    }
    for (const Spot& spot : spots) {
        result.scatter_px += 0.5 * (spot.at - result.mean).squaredNorm() / (count - 1.0);
    }
    result.scatter_px = std::sqrt(result.scatter_px);
    return result;
}

struct BothOutlines {
    Outlines images{};
    Outlines without{};
};
BothOutlines outlines_of(const Scene& scene, int images, std::uint64_t seed = 5) {
    const TrueCamera camera = plain_camera();
    const SensorPattern pattern(camera, 3);
    RenderScratch render_scratch;
    SpotScratch scratch;
    SpotFinder finder{SpotSettings{}};
    std::vector<Spot> spots;
    Rng rng(seed);
    Image image;
    std::vector<Spot> of_images;
    std::vector<Spot> of_none;
    render_light(camera, {&scene, 1}, 1, render_scratch);
    for (int i = 0; i < images; ++i) {
        expose(camera.sensor, pattern, render_scratch.field, scene.ambient, static_cast<std::uint64_t>(100 + i), image);
        of_images.push_back(finder.find(image.view()).spots.at(0));
        spots_without_images(camera, {&scene, 1}, {}, rng, scratch, spots);
        of_none.push_back(spots.at(0));
    }
    return {outlines_of(of_images), outlines_of(of_none)};
}

Scene sphere_with_lobe(double x) {
    Scene scene = one_sphere({x, -2.0, 450.0});
    scene.spheres[0].lobe = 0.5;
    return scene;
}

}  // namespace

TEST_CASE("outlines without images are off as those of images are: whole, worn, half hidden, or beside a glint" *
          doctest::skip(rhexis::testing::sanitized)) {
    constexpr int images = 60;
    Scene worn = sphere_with_lobe(3.0);
    worn.spheres[0].worn_towards = Vec3(0.85, 0.2, -0.487);
    worn.spheres[0].worn_cosine = 0.8;
    worn.spheres[0].worn_left = 0.3;
    Scene hidden = sphere_with_lobe(3.0);
    hidden.capsules = {{Vec3(5.4, -20.0, 400.0), Vec3(5.8, 20.0, 410.0), 1.5, 0.5, 6.0}};
    Scene glint = sphere_with_lobe(3.0);
    glint.glints = {{Vec3(6.3, -2.0, 450.0), 120.0, 1.5}};
    double most_moved = 0.0;
    for (const Scene& scene : {worn, hidden, glint}) {
        const BothOutlines both = outlines_of(scene, images);
        const Vec2 whole = distorted(plain_camera().lens, outline(scene.spheres[0]).centre);
        MESSAGE("off ", (both.images.mean - whole).norm(), " px, without images ", (both.without.mean - whole).norm(),
                ", apart ", (both.images.mean - both.without.mean).norm(), ", scatter ", both.images.scatter_px,
                " and ", both.without.scatter_px);
        CHECK((both.images.mean - both.without.mean).norm() < 0.03);
        CHECK(both.without.scatter_px == doctest::Approx(both.images.scatter_px).epsilon(0.35));
        CHECK(both.without.area == doctest::Approx(both.images.area).epsilon(0.01));
        CHECK(both.without.roundness == doctest::Approx(both.images.roundness).epsilon(0.01));
        most_moved = std::max(most_moved, (both.images.mean - whole).norm());
    }
    CHECK(most_moved > 0.015);  // something was to be told
    double moved = 0.0;
    double moved_without = 0.0;
    double scatter = 0.0;
    double scatter_without = 0.0;
    for (int i = 0; i < 20; ++i) {
        const Scene scene = sphere_with_lobe(0.037 * i);
        const BothOutlines both = outlines_of(scene, images / 4, static_cast<std::uint64_t>(i));
        const Vec2 whole = distorted(plain_camera().lens, outline(scene.spheres[0]).centre);
        moved += (both.images.mean - whole).squaredNorm();
        moved_without += (both.without.mean - whole).squaredNorm();
        scatter += both.images.scatter_px;
        scatter_without += both.without.scatter_px;
        CHECK(both.without.area == doctest::Approx(both.images.area).epsilon(0.01));
    }
    MESSAGE("whole spheres: off ", std::sqrt(moved / 20), " and ", std::sqrt(moved_without / 20), ", scatter ",
            scatter / 20, " and ", scatter_without / 20);
    CHECK(scatter_without == doctest::Approx(scatter).epsilon(0.3));
    CHECK(std::sqrt(moved_without) == doctest::Approx(std::sqrt(moved)).epsilon(0.5));
}

TEST_CASE("spots without images are where images have them, and scatter as widely" *
          doctest::skip(rhexis::testing::sanitized)) {
    const TrueCamera camera = true_lens_camera();
    const Scene scene = spread_spheres();
    constexpr int images = 100;
    const Agreement images_say = agreement_with_images(camera, scene, images);
    MESSAGE("bias " << images_say.bias.transpose() << ", worst " << images_say.worst << ", noise " << images_say.noise);
    CHECK(images_say.bias.norm() < 0.002);
    CHECK(images_say.worst < 0.01);

    SpotScratch scratch;
    std::vector<Spot> spots;
    Rng rng(5);
    spots_without_images(camera, {&scene, 1}, without_noise(), rng, scratch, spots);
    const std::vector<Spot> exact = spots;
    REQUIRE(exact.size() == 16);
    double squares = 0.0;
    for (int i = 0; i < images; ++i) {
        spots_without_images(camera, {&scene, 1}, by_light(), rng, scratch, spots);
        for (std::size_t j = 0; j < spots.size(); ++j) {
            squares += 0.5 * (spots[j].at - exact[j].at).squaredNorm() / (images * 16.0);
        }
    }
    MESSAGE("noise without images " << std::sqrt(squares));
    CHECK(std::sqrt(squares) == doctest::Approx(images_say.noise).epsilon(0.15));
}

TEST_CASE("without lobe, vignetting or bends a spot's centre is the ellipse's; taking one away moves it") {
    TrueCamera camera = plain_camera(1280, 1024);
    Sphere sphere;
    sphere.centre = {120.0, 60.0, 430.0};
    sphere.lobe = 0.0;
    const Vec2 ellipse = distorted(camera.lens, outline(sphere).centre);
    CHECK((centre_of_light(camera, sphere) - ellipse).norm() < 1e-4);
    CHECK((ellipse - *project(camera, sphere.centre)).norm() > 0.02);
    camera.optics.vignetting = 0.35;
    CHECK((centre_of_light(camera, sphere) - ellipse).norm() > 0.005);
}

TEST_CASE("what images show of partly hidden, worn and moving markers, spots without images tell too") {
    const TrueCamera camera = plain_camera();
    SpotScratch scratch;
    RenderScratch render_scratch;
    std::vector<Spot> spots;
    Rng rng(1);
    Scene scene = one_sphere({3.0, -2.0, 450.0});
    scene.spheres[0].lobe = 0.5;
    for (int kind = 0; kind < 3; ++kind) {
        std::vector<Scene> instants(8, scene);
        if (kind == 0) {
            for (Scene& instant : instants) {
                instant.capsules = {{Vec3(1.6, -20.0, 400.0), Vec3(2.4, 20.0, 410.0), 1.5, 0.5, 0.0}};
            }
        } else if (kind == 1) {
            for (Scene& instant : instants) {
                instant.spheres[0].worn_towards = Vec3(0.6, 0.0, -0.8);
                instant.spheres[0].worn_cosine = 0.8;
                instant.spheres[0].worn_left = 0.3;
            }
        } else {
            for (std::size_t i = 0; i < instants.size(); ++i) {
                instants[i].spheres[0].centre.x() += 0.2 * static_cast<double>(i);
            }
        }
        render_light(camera, instants, 1, render_scratch);
        const LightMoments image = moments_of(render_scratch.field);
        spots_without_images(camera, instants, without_noise(), rng, scratch, spots);
        REQUIRE(spots.size() == 1);
        CHECK((spots[0].at - image.mean).norm() < 0.08);
        const double half = 0.5 * image.spread.trace();
        const double root = std::sqrt(half * half - image.spread.determinant());
        CHECK(spots[0].roundness == doctest::Approx(std::sqrt((half - root) / (half + root))).epsilon(0.03));
        CHECK((kind != 2 || spots[0].roundness < 0.97));
        const Vec2 whole = centre_of_light(camera, scene.spheres[0]);
        CHECK((image.mean - whole).norm() > 0.2);
    }
}

TEST_CASE("markers out of view or hidden give no spot, markers that touch give one, and specks come as often as said") {
    const TrueCamera camera = plain_camera();
    SpotScratch scratch;
    std::vector<Spot> spots;
    Rng rng(1);
    const auto count = [&](const Scene& scene) {
        spots_without_images(camera, {&scene, 1}, by_light(), rng, scratch, spots);
        return spots.size();
    };
    Scene scene = one_sphere({0.0, 0.0, 450.0});
    CHECK(count(scene) == 1);
    CHECK(spots[0].area == doctest::Approx(3.14159 * 11.11 * 11.11).epsilon(0.01));
    CHECK(spots[0].roundness > 0.99);
    CHECK_FALSE(spots[0].clipped);
    CHECK_FALSE(spots[0].at_rim);
    scene.spheres[0].light = 400.0;
    CHECK(count(scene) == 1);
    CHECK(spots[0].clipped);
    scene.discs = {{Vec3(0.0, 0.0, 300.0), Vec3::UnitZ(), 10.0, 0.5}};
    CHECK(count(scene) == 0);
    CHECK(count(one_sphere({100.0, 0.0, 450.0})) == 0);
    CHECK(count(one_sphere({0.0, 0.0, -450.0})) == 0);
    CHECK(count(one_sphere({42.0, 0.0, 450.0})) == 1);
    CHECK(spots[0].at_rim);
    scene = one_sphere({0.0, 0.0, 450.0});
    scene.spheres.push_back(scene.spheres[0]);
    scene.spheres[1].centre = {6.0, 0.0, 452.0};
    CHECK(count(scene) == 1);
    CHECK(spots[0].roundness < 0.6);
    scene.spheres[1].centre = {9.0, 0.0, 452.0};
    CHECK(count(scene) == 2);
    // a glint at one marker's rim does not make it reach the other
    scene.glints = {{Vec3(-3.5, 0.0, 450.0), 150.0, 1.0}};
    CHECK(count(scene) == 2);
    scene.glints = {{Vec3(4.5, 0.0, 450.0), 250.0, 3.0}};
    CHECK(count(scene) == 1);
    scene.glints.clear();
    scene.spheres.clear();
    scene.specks = 0.5;
    std::size_t specks = 0;
    for (int i = 0; i < 2000; ++i) {
        specks += count(scene);
    }
    CHECK(specks > 900);
    CHECK(specks < 1100);
}

}  // namespace rhexis::tracking::synthetic
