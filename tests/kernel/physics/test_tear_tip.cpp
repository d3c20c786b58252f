// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "mesh/shapes.hpp"
#include "physics/membrane/tear_tip.hpp"

using namespace rhexis;

namespace {

constexpr double degree = M_PI / 180.0;

Vec2 at_angle(double degrees) { return {std::cos(degrees * degree), std::sin(degrees * degree)}; }

double angle_of(const Vec2& d) {
    double angle = std::atan2(d.y(), d.x()) / degree;
    while (angle < 0.0) {
        angle += 180.0;
    }
    return angle;
}

/// Best of directions tried one after the other.
double searched(const Mat2& stress, const Vec2& fibre, double ratio) {
    double best = 0.0;
    double most = -1e300;
    for (double angle = 0.0; angle < 180.0; angle += 0.01) {
        const Vec2 u(-at_angle(angle).y(), at_angle(angle).x());
        const double along = u.dot(fibre);
        const double value = u.dot(stress * u) / (1.0 + (ratio - 1.0) * along * along);
        if (value > most) {
            most = value;
            best = angle;
        }
    }
    return best;
}

}  // namespace

TEST_SUITE("tear tip") {
    TEST_CASE("direction of a tear under a pull along x, strength 4 times as large across the fibres") {
        Mat2 pull;
        pull << 1.0, 0.0, 0.0, 0.0;
        const double fibres[5] = {15.0, 30.0, 45.0, 60.0, 75.0};
        const double table[5] = {58.0, 53.4, 59.0, 68.2, 78.8};
        for (int i = 0; i < 5; ++i) {
            const std::optional<Vec2> way = tear_direction(pull, at_angle(fibres[i]), 4.0, Vec2::Zero(), 0.0);
            REQUIRE(way);
            CHECK(angle_of(*way) == doctest::Approx(table[i]).epsilon(1.5e-3));
        }
        CHECK(angle_of(*tear_direction(pull, at_angle(30.0), 1.0, Vec2::Zero(), 0.0)) == doctest::Approx(90.0));
    }

    TEST_CASE("the closed form is the best of all directions") {
        for (int i = 0; i < 40; ++i) {
            Mat2 stress;
            stress << std::cos(1.0 * i), 0.7 * std::sin(2.3 * i), 0.7 * std::sin(2.3 * i), 0.5 + std::sin(0.7 * i);
            const Vec2 fibre = at_angle(23.0 * i);
            const std::optional<Vec2> way = tear_direction(stress, fibre, 1.0 + 0.2 * i, Vec2::Zero(), 0.0);
            if (way) {
                double off = std::abs(angle_of(*way) - searched(stress, fibre, 1.0 + 0.2 * i));
                off = std::min(off, 180.0 - off);
                CHECK(off < 0.02);
            }
        }
    }

    TEST_CASE("a tear stays within the cone about the way it came, and does not start under pressure") {
        Mat2 pull;
        pull << 1.0, 0.0, 0.0, 0.2;
        const Vec2 came = at_angle(10.0);
        const std::optional<Vec2> way = tear_direction(pull, at_angle(0.0), 1.0, came, std::cos(30.0 * degree));
        REQUIRE(way);
        CHECK(angle_of(*way) == doctest::Approx(40.0));
        const Mat2 pressed = -pull;
        CHECK_FALSE(tear_direction(pressed, at_angle(0.0), 1.0, Vec2::Zero(), 0.0));
    }
}
