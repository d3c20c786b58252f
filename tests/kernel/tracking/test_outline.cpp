// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "support/sanitized.hpp"
#include "synthetic_support.hpp"
#include "tracking/measure/centroid_errors.hpp"
#include "tracking/measure/other_detectors.hpp"
#include "tracking/spots/outline.hpp"
#include "tracking/spots/spot_finder.hpp"

namespace rhexis::tracking {
namespace {

/// One sphere on the axis, seen by a plain camera.
struct SeenDisc {
    synthetic::TrueCamera camera = synthetic::plain_camera();
    synthetic::SensorPattern pattern{camera, 5};
    synthetic::RenderScratch scratch{};
    synthetic::Image image{};
    synthetic::Scene scene = synthetic::one_sphere({0.3, -0.2, 450.0});
    Vec2 wanted{159.5 + 1667.0 * 0.3 / 450.0, 127.5 - 1667.0 * 0.2 / 450.0};
    double radius_px = 1667.0 * 3.0 / 450.0;

    SeenDisc() { scene.spheres[0].lobe = 0.5; }
    GreyImage look() {
        render(camera, pattern, {&scene, 1}, 9, scratch, image);
        return image.view();
    }
    std::optional<FittedOutline> outline(const Vec2& begun_off = Vec2::Zero()) {
        return fit_outline(look(), wanted + begun_off, radius_px, 130.0, {});
    }
};

}  // namespace

TEST_CASE("an outline's centre, width and share are those of the sphere's image, wherever the fit begins near it") {
    SeenDisc seen;
    for (const Vec2& off : {Vec2(0, 0), Vec2(1.5, -0.7), Vec2(-2.0, 1.0)}) {
        const std::optional<FittedOutline> outline = seen.outline(off);
        REQUIRE(outline.has_value());
        CHECK((outline->centre - seen.wanted).norm() < 0.04);
        CHECK(outline->radius == doctest::Approx(seen.radius_px).epsilon(0.03));
        CHECK(outline->stretch < 0.05);
        CHECK(outline->share > 0.95);
        CHECK(outline->sigma_px < 0.03);
    }
}

TEST_CASE("a worn patch and a hand beside it move an outline little, a centre of light much") {
    SeenDisc seen;
    seen.scene.spheres[0].worn_towards = Vec3(0.6, 0.0, -0.8);
    seen.scene.spheres[0].worn_cosine = 0.8;
    seen.scene.spheres[0].worn_left = 0.5;
    seen.scene.capsules = {{Vec3(-4.5, -40.0, 455.0), Vec3(-4.5, 40.0, 455.0), 2.0, 0.5, 12.0}};
    const std::optional<FittedOutline> outline = seen.outline();
    REQUIRE(outline.has_value());
    CHECK((outline->centre - seen.wanted).norm() < 0.3);
    SpotSettings light;
    light.outlines = false;
    light.low = 0.0;
    light.high = 1.0;
    SpotFinder finder(light);
    const std::vector<Spot>& spots = finder.find(seen.look()).spots;
    REQUIRE(spots.size() == 1);
    CHECK((spots[0].at - seen.wanted).norm() > 0.5);
}

TEST_CASE("where too little of the rim is seen there is no outline, and none of a few bright pixels") {
    SeenDisc seen;
    const auto hide = [&seen](double beside_mm) {
        seen.scene.discs = {{Vec3(60.0 + beside_mm, 0.0, 430.0), Vec3::UnitZ(), 60.0, 0.2}};
    };
    hide(1.8);
    const std::optional<FittedOutline> most = seen.outline();
    REQUIRE(most.has_value());
    CHECK(most->share < 0.9);
    CHECK((most->centre - seen.wanted).norm() < 0.15);
    hide(-0.5);
    const std::optional<FittedOutline> little = seen.outline();
    CHECK((!little || little->stretch > 0.5));
    CHECK_FALSE(fit_outline(seen.look(), {40.0, 40.0}, 8.0, 130.0, {}).has_value());
    CHECK_FALSE(fit_outline(seen.look(), seen.wanted, 1.5, 130.0, {}).has_value());
}

TEST_CASE("spots say how sure they are, and are as sure as they say" * doctest::skip(rhexis::testing::sanitized)) {
    const Result<CentroidErrors> errors = measure_centroids(22.0, 4, 5, SpotSettings{});
    REQUIRE(errors.ok());
    MESSAGE("off ", errors.value().rms_px, " px each way, told ", errors.value().told_sigma_px);
    CHECK(errors.value().samples > 100);
    CHECK(errors.value().missed == 0);
    CHECK(errors.value().rms_px < 0.02);
    CHECK(errors.value().told_sigma_px == doctest::Approx(errors.value().rms_px).epsilon(0.5));
}

TEST_CASE("OpenCV's detectors find the same spot, less surely") {
    SeenDisc seen;
    for (const std::vector<Spot>& spots : {contour_spots(seen.look(), 60), component_spots(seen.look(), 60)}) {
        REQUIRE(spots.size() == 1);
        CHECK((spots[0].at - seen.wanted).norm() < 0.3);
        CHECK(spots[0].area == doctest::Approx(std::numbers::pi * seen.radius_px * seen.radius_px).epsilon(0.15));
    }
    seen.scene.spheres.clear();
    CHECK(contour_spots(seen.look(), 60).empty());
    CHECK(component_spots(seen.look(), 60).empty());
}

}  // namespace rhexis::tracking
