// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "tracking/calibration/pivot.hpp"

namespace rhexis::tracking {
namespace {

constexpr double radians_per_degree = 3.14159265358979 / 180.0;
const Vec3 true_tip{4.0, -7.0, -96.0};
const Vec3 true_pivot{12.0, 30.0, -5.0};
const Vec3 true_axis = Vec3(0.05, -0.1, 1.0).normalized();

Vec3 noise_of(Rng& rng, double size) { return size * normal3(rng); }

/// Swung through a cone of half an angle, with spin; noise of a tracker.
std::vector<Pose> swung(double half_angle_deg, int count, double noise_mm) {
    Rng rng(3, "swing");
    std::vector<Pose> poses;
    for (int i = 0; i < count; ++i) {
        const double tilt = half_angle_deg * radians_per_degree * std::sqrt(rng.uniform());
        const double around = 6.283 * rng.uniform();
        const Vec3 hinge(std::cos(around), std::sin(around), 0.0);
        Pose pose;
        pose.orientation = Quat(Eigen::AngleAxisd(tilt, hinge));
        pose.position = true_pivot - pose.orientation * true_tip + noise_of(rng, noise_mm);
        poses.push_back(pose);
    }
    return poses;
}

std::vector<Pose> spun(double most_deg, double wobble) {
    Rng rng(4, "spin");
    const Quat placed(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    std::vector<Pose> poses;
    for (int i = 0; i < 100; ++i) {
        const Quat turn(Eigen::AngleAxisd(most_deg * radians_per_degree * i / 100.0, true_axis));
        const Vec3 off = noise_of(rng, wobble);
        const Quat astray(Eigen::AngleAxisd(off.norm(), off.normalized()));
        poses.push_back({Vec3::Zero(), placed * turn * astray});
    }
    return poses;
}

std::string pivot_error(const std::vector<Pose>& poses) {
    const Result<PivotCalibration> found = calibrate_pivot(poses);
    return found ? std::string("ok") : found.error().text();
}

}  // namespace

TEST_CASE("a tip swung about a point is found exactly, and with noise within its standard deviation") {
    const Result<PivotCalibration> exact = calibrate_pivot(swung(30.0, 60, 0.0));
    REQUIRE(exact.ok());
    CHECK((exact.value().tip - true_tip).norm() < 1e-9);
    CHECK((exact.value().pivot - true_pivot).norm() < 1e-9);
    CHECK(exact.value().spread_deg == doctest::Approx(15.0).epsilon(0.15));

    const Result<PivotCalibration> noisy = calibrate_pivot(swung(30.0, 300, 0.05));
    REQUIRE(noisy.ok());
    CHECK((noisy.value().tip - true_tip).norm() < 3.0 * noisy.value().tip_sigma_mm);
    CHECK(noisy.value().tip_sigma_mm < 0.03);
    CHECK(noisy.value().residual_mm == doctest::Approx(0.05 * std::sqrt(3.0)).epsilon(0.15));
    CHECK(noisy.value().condition > 1.0);
}

TEST_CASE("less turning makes the equations worse, and too little is refused with how much is needed") {
    CHECK(calibrate_pivot(swung(20.0, 60, 0.0)).value().condition >
          1.3 * calibrate_pivot(swung(40.0, 60, 0.0)).value().condition);
    const std::string text = pivot_error(swung(5.0, 60, 0.0));
    CHECK(text.find("the direction that turned least is spread by") != std::string::npos);
    CHECK(text.find("cone of 40 degrees") != std::string::npos);
}

TEST_CASE("turning about the shaft alone does not show where the tip is along it") {
    CHECK(pivot_error(spun(360.0, 0.0)).find("turned least is spread by 0 degrees") != std::string::npos);
}

TEST_CASE("a tip that slips, too few poses and poses that are none are refused") {
    std::vector<Pose> slipped = swung(30.0, 60, 0.0);
    for (std::size_t i = 30; i < 60; ++i) {
        slipped[i].position.x() += 3.0;
    }
    CHECK(pivot_error(slipped).find("mm from the pivot") != std::string::npos);
    CHECK(pivot_error(swung(30.0, 12, 0.0)).find("12 poses (at least 30)") != std::string::npos);
    std::vector<Pose> broken = swung(30.0, 60, 0.0);
    broken[6].position.y() = std::nan("");
    CHECK(pivot_error(broken).find("pose 7 is not") != std::string::npos);
}

TEST_CASE("a shaft turned about itself shows its axis, towards the hand") {
    const Result<ShaftCalibration> exact = calibrate_shaft(spun(360.0, 0.0), Vec3(0, 0, 50));
    REQUIRE(exact.ok());
    CHECK((exact.value().axis - true_axis).norm() < 1e-7);
    CHECK((calibrate_shaft(spun(360.0, 0.0), Vec3(0, 0, -50)).value().axis + true_axis).norm() < 1e-7);
    const Result<ShaftCalibration> noisy = calibrate_shaft(spun(360.0, 0.002), Vec3(0, 0, 50));
    REQUIRE(noisy.ok());
    CHECK((noisy.value().axis - true_axis).norm() < 0.001);
    CHECK(noisy.value().residual_deg > 0.05);
}

TEST_CASE("a shaft that was hardly turned, or that strays, is refused") {
    const Result<ShaftCalibration> little = calibrate_shaft(spun(30.0, 0.0), Vec3(0, 0, 50));
    REQUIRE_FALSE(little.ok());
    CHECK(little.error().text().find("turn it once around") != std::string::npos);
    const Result<ShaftCalibration> astray = calibrate_shaft(spun(360.0, 0.1), Vec3(0, 0, 50));
    REQUIRE_FALSE(astray.ok());
    CHECK(astray.error().text().find("the shaft strays by") != std::string::npos);
}

TEST_CASE("a tip's pose has its z along the shaft and its x beside") {
    const Pose tip = tip_pose(true_tip, true_axis, Vec3::UnitX());
    CHECK((tip.orientation * Vec3::UnitZ() - true_axis).norm() < 1e-12);
    CHECK((tip.orientation * Vec3::UnitX()).dot(Vec3::UnitX()) > 0.99);
    CHECK((tip.position - true_tip).norm() == 0.0);
}

}  // namespace rhexis::tracking
