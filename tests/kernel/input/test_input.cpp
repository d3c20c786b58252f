// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <limits>

#include "input/device.hpp"
#include "input/sample_check.hpp"

using namespace rhexis;

TEST_SUITE("input") {
    TEST_CASE("a sample is refused for each field that makes no sense") {
        DeviceSample good;
        good.present = true;
        REQUIRE(checked_sample(good, 1).ok());
        DeviceSample bad = good;
        bad.pose.position.x() = 1e6;
        CHECK(checked_sample(bad, 1).error().text() == "device sample: pose.position.x is 1000000 (-200 to 200)");
        bad = good;
        bad.pose.orientation.coeffs().setZero();
        CHECK(checked_sample(bad, 1).error().what == "pose.orientation length is 0");
        bad = good;
        bad.pose.orientation.x() = std::numeric_limits<double>::infinity();
        CHECK_FALSE(checked_sample(bad, 1).ok());
        bad = good;
        bad.jaw = -0.1;
        CHECK(checked_sample(bad, 1).error().what == "jaw is -0.1");
        bad = good;
        bad.pedal = std::numeric_limits<double>::quiet_NaN();
        CHECK(checked_sample(bad, 1).error().what == "pedal is nan");
        bad = good;
        bad.instrument = 1;
        CHECK(checked_sample(bad, 1).error().allowed == "0 to 0");
    }

    TEST_CASE("an orientation that rounding has made too long is taken as a unit quaternion") {
        DeviceSample sample;
        sample.pose.orientation.coeffs() *= 1.005;
        CHECK(checked_sample(sample, 1).value().pose.orientation.norm() == doctest::Approx(1.0).epsilon(1e-15));
    }

    TEST_CASE("a scripted device is silent before its first keyframe, moves evenly and stays at its last") {
        DeviceSample a;
        a.present = true;
        DeviceSample b = a;
        b.pose.position = Vec3(2.0, 0.0, 0.0);
        b.pedal = 3.0;
        ScriptedDevice device({{1.0, a}, {2.0, b}});
        CHECK(device.read(50, 0.5).empty());
        REQUIRE(device.read(125, 1.25).size() == 1);
        CHECK(device.read(125, 1.25)[0].pose.position.x() == doctest::Approx(0.5));
        CHECK(device.read(125, 1.25)[0].pedal == doctest::Approx(0.75));
        CHECK(device.read(900, 9.0)[0].pose.position.x() == 2.0);
    }

    TEST_CASE("a recorded device gives each step its samples and is silent afterwards") {
        DeviceSample sample;
        sample.pedal = 1.0;
        RecordedDevice device({{sample}, {}, {sample, sample}});
        CHECK(device.read(1, 0.01).size() == 1);
        CHECK(device.read(2, 0.02).empty());
        CHECK(device.read(3, 0.03).size() == 2);
        CHECK(device.read(4, 0.04).empty());
        CHECK(device.read(0, 0.0).empty());
    }
}
