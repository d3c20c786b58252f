// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "make_renderer.hpp"
#include "scenes/golden_frames.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

// Drivers round otherwise, and edges fall on other pixels: of a tile's mean so much may be other, of all tiles' less.
constexpr double of_a_tile = 6.0;
constexpr double of_all = 1.0;

}  // namespace

TEST_CASE("pictures are as they were, tile by tile") {
    std::ifstream file("tests/data/pictures/golden.json");
    REQUIRE(file.is_open());
    const nlohmann::json golden = nlohmann::json::parse(file);
    Renderer renderer = make_renderer(golden_width, golden_height);
    std::size_t seen = 0;
    for (const GoldenFrame& one : golden_frames()) {
        REQUIRE_MESSAGE(golden.contains(one.name), one.name);
        const nlohmann::json& wanted = golden.at(one.name);
        const std::vector<std::array<double, 3>> tiles = tiles_of(golden_picture(renderer, one));
        REQUIRE(wanted.size() == 3 * tiles.size());
        double most = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const double apart = std::abs(tiles[i / 3][i % 3] - wanted[i].get<double>());
            most = std::max(most, apart);
            sum += apart;
        }
        CHECK_MESSAGE(most <= of_a_tile, one.name);
        CHECK_MESSAGE(sum <= of_all * static_cast<double>(wanted.size()), one.name);
        ++seen;
    }
    CHECK(seen == golden.size());
}

TEST_CASE("another picture is told from the one that was") {
    const std::vector<GoldenFrame> frames = golden_frames();
    Renderer renderer = make_renderer(golden_width, golden_height);
    const auto whole = tiles_of(golden_picture(renderer, frames[0]));
    const auto brunescent = tiles_of(golden_picture(renderer, frames[1]));
    double most = 0.0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        most = std::max(most, std::abs(whole[i][0] - brunescent[i][0]));
    }
    CHECK(most > of_a_tile);
}
