// SPDX-License-Identifier: GPL-3.0-or-later
// Whole attempts at the groove.
#include <doctest/doctest.h>

#include <cmath>

#include "../attempt.hpp"

using namespace rhexis;
using rhexis::test::Attempt;

namespace {

struct Outcome {
    double scaled = 0.0;
    bool completed = false;
    std::uint64_t hash = 0;
};

Outcome whole(const std::string& surgeon, std::uint64_t seed) {
    Attempt attempt(surgeon, seed);
    attempt.run(300.0);
    const nlohmann::json result = attempt.result();
    return {result.at("osacss").at("scaled"), result.at("completed"), attempt.session().state_hash()};
}

}  // namespace

TEST_CASE("experts score above novices, seed by seed in the mean and mostly each") {
    double expert_sum = 0.0;
    double novice_sum = 0.0;
    int better = 0;
    constexpr int seeds = 5;
    for (std::uint64_t seed = 101; seed < 101 + seeds; ++seed) {
        const Outcome expert = whole("expert", seed);
        const Outcome novice = whole("novice", seed);
        expert_sum += expert.scaled;
        novice_sum += novice.scaled;
        better += expert.scaled > novice.scaled ? 1 : 0;
        CAPTURE(seed);
        CHECK(expert.completed);
    }
    CHECK(expert_sum > novice_sum + 0.1 * seeds);
    CHECK(better >= seeds - 1);
}

TEST_CASE("the same seed gives the same attempt to the last bit") {
    CHECK(whole("novice", 7).hash == whole("novice", 7).hash);
}
