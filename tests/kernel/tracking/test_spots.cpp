// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "tracking/spots/spot_finder.hpp"

namespace rhexis::tracking {
namespace {

struct Canvas {
    int width = 200;
    int height = 120;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(static_cast<std::size_t>(200 * 120), 10);

    [[nodiscard]] GreyImage view() const { return {pixels.data(), width, height, width}; }
    std::uint8_t& at(int x, int y) { return pixels[static_cast<std::size_t>(y * width + x)]; }

    /// A disc whose rim is blurred over about two pixels, with noise.
    void disc(const Vec2& centre, double radius, double light, double noise, Rng& rng) {
        constexpr int fine = 8;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                double share = 0.0;
                for (int k = 0; k < fine * fine; ++k) {
                    const Vec2 sub(x + (k % fine + 0.5) / fine - 0.5, y + (k / fine + 0.5) / fine - 0.5);
                    share += 1.0 / (1.0 + std::exp(((sub - centre).norm() - radius) / 0.4));
                }
                const double now = at(x, y) + light * share / (fine * fine) + noise * rng.normal();
                at(x, y) = static_cast<std::uint8_t>(std::clamp(std::round(now), 0.0, 255.0));
            }
        }
    }
};

const FoundSpots& found_in(SpotFinder& finder, const Canvas& canvas) { return finder.find(canvas.view()); }

}  // namespace

TEST_CASE("a disc's centre is found to two hundredths of a pixel, wherever between pixels it is") {
    Rng rng(3);
    SpotFinder finder({});
    double squares = 0.0;
    constexpr int count = 60;
    for (int i = 0; i < count; ++i) {
        Canvas canvas;
        const Vec2 centre = Vec2(60.0, 40.0) + uniform2(rng).cwiseProduct(Vec2(40.0, 30.0));
        const double radius = 2.5 + 8.0 * rng.uniform();
        canvas.disc(centre, radius, 170.0, 1.5, rng);
        const FoundSpots& found = found_in(finder, canvas);
        REQUIRE(found.spots.size() == 1);
        squares += (found.spots[0].at - centre).squaredNorm();
        CHECK(found.spots[0].roundness > 0.93);
        CHECK(found.spots[0].area == doctest::Approx(3.14159 * radius * radius).epsilon(0.12));
        CHECK_FALSE(found.spots[0].at_rim);
        CHECK_FALSE(found.spots[0].clipped);
    }
    const double each_way = std::sqrt(squares / (2 * count));
    MESSAGE("root mean square of the centre, each way: ", each_way, " pixels");
    CHECK(each_way < 0.02);
}

TEST_CASE("a spot is the same at every place of the blocks that are skipped") {
    SpotSettings settings;
    settings.outlines = false;  // a square has none
    SpotFinder finder(settings);
    for (int left = 20; left < 90; ++left) {
        Canvas canvas;
        for (int y = 50; y < 55; ++y) {
            for (int x = left; x < left + 5; ++x) {
                canvas.at(x, y) = 200;
            }
        }
        const FoundSpots& found = found_in(finder, canvas);
        REQUIRE(found.spots.size() == 1);
        CHECK(found.spots[0].at.x() == doctest::Approx(left + 2.0));
        CHECK(found.spots[0].at.y() == doctest::Approx(52.0));
        CHECK(found.spots[0].area == doctest::Approx(25.0));
    }
}

TEST_CASE("arms that meet below are one region; two that a pixel parts are two, and crowded") {
    SpotFinder finder({});
    Canvas u;
    for (int y = 40; y < 50; ++y) {
        for (int x = 30; x < 50; ++x) {
            if (x < 33 || x >= 47 || y >= 47) {
                u.at(x, y) = 180;
            }
        }
    }
    CHECK(found_in(finder, u).spots.size() == 1);
    Canvas two;
    for (int y = 40; y < 50; ++y) {
        for (int x = 30; x < 41; ++x) {
            two.at(x, y) = x == 35 ? 10 : 180;
        }
    }
    const FoundSpots& found = found_in(finder, two);
    REQUIRE(found.spots.size() == 2);
    CHECK(found.spots[0].crowded);
    CHECK(found.spots[1].crowded);
    CHECK(found.spots[0].at.x() == doctest::Approx(32.0).epsilon(0.01));
}

TEST_CASE("half a disc is not round, one at the rim says so, a hot pixel is no spot, a lamp is not one either") {
    Rng rng(4);
    SpotFinder finder({});
    Canvas half;
    half.disc({80, 60}, 10, 170, 0.0, rng);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 80; x < half.width; ++x) {
            half.at(x, y) = 10;
        }
    }
    REQUIRE(found_in(finder, half).spots.size() == 1);
    CHECK(finder.find(half.view()).spots[0].roundness < 0.6);
    Canvas rim;
    rim.disc({2, 60}, 6, 170, 0.0, rng);
    REQUIRE(found_in(finder, rim).spots.size() == 1);
    CHECK(finder.find(rim.view()).spots[0].at_rim);
    Canvas hot;
    hot.at(77, 33) = 255;
    CHECK(found_in(finder, hot).spots.empty());
    Canvas lamp;
    std::fill(lamp.pixels.begin(), lamp.pixels.end(), std::uint8_t{255});
    CHECK(found_in(finder, lamp).spots.empty());
    Canvas dark;
    CHECK(found_in(finder, dark).spots.empty());
}

TEST_CASE("of more spots than may be, the first are kept and it is told") {
    SpotSettings settings;
    settings.most_spots = 10;
    SpotFinder finder(settings);
    Canvas many;
    for (int y = 5; y < 110; y += 10) {
        for (int x = 5; x < 190; x += 10) {
            for (int k = 0; k < 16; ++k) {
                many.at(x + k % 4, y + k / 4) = 200;
            }
        }
    }
    const FoundSpots& found = found_in(finder, many);
    CHECK(found.too_many);
    CHECK(found.spots.size() == 10);
    CHECK(found.spots[9].at.y() == doctest::Approx(6.5));
}

}  // namespace rhexis::tracking
