// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "math/decay.hpp"

using namespace rhexis;

TEST_SUITE("decay") {
    TEST_CASE("it is the exponential and its mean, from nothing to what underflows") {
        for (const double x : {0.0, 1e-300, 1e-12, 1e-3, 0.124, 0.126, 0.5, 1.0, 3.0, 10.0, 64.0, 100.0}) {
            const Decay d = decay(x);
            CHECK(std::abs(d.left - std::exp(-x)) <= 1e-13 * std::exp(-x));
            const double mean = x > 0.0 ? -std::expm1(-x) / x : 1.0;
            CHECK(std::abs(d.mean - mean) <= 1e-13 * mean);
        }
        CHECK(decay(1e6).left == 0.0);
        CHECK(decay(1e6).mean == doctest::Approx(1e-6).epsilon(1e-14));
    }
}
