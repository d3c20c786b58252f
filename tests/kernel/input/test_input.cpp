// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <limits>

#include "input/step_input.hpp"

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

    TEST_CASE("a step takes the last sample of an instrument that makes sense, and says which did not") {
        DeviceSample first;
        first.present = true;
        first.pedal = 1.0;
        DeviceSample second = first;
        second.pedal = 2.0;
        DeviceSample broken = first;
        broken.jaw = 7.0;
        DeviceSample nobodys = first;
        nobodys.instrument = 5;
        const StepInput input = read_samples(std::vector<DeviceSample>{first, second, broken, nobodys}, 2);
        REQUIRE(input.samples.size() == 2);
        REQUIRE(input.samples[0].has_value());
        CHECK(input.samples[0]->pedal == 2.0);
        CHECK_FALSE(input.samples[1].has_value());
        REQUIRE(input.refused.size() == 2);
        CHECK(input.refused[0].instrument == 0);
        CHECK(input.refused[0].why == "device sample: jaw is 7 (0 to 1)");
        CHECK(input.refused[1].instrument == 5);
        CHECK(read_samples({}, 3).samples.size() == 3);
    }
}
