// SPDX-License-Identifier: GPL-3.0-or-later
// Whole attempts at the groove.
#include <doctest/doctest.h>

#include <cmath>

#include "../attempt.hpp"
#include "base/rng.hpp"

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

TEST_CASE("ten minutes of a random operator end with finite numbers and no mass lost") {
    Attempt attempt("none", 11, {{"time_limit_s", "7200"}});
    Rng rng(11, "random operator");
    attempt.appear(Vec3(0.0, 0.0, 3.0));
    while (attempt.session().time_s() < 600.0) {
        const Vec3 place(6.0 * rng.uniform() - 3.0, 6.0 * rng.uniform() - 3.0, 6.0 * rng.uniform() - 3.0);
        attempt.move(place, 1.0 + 15.0 * rng.uniform(), 3.0 * rng.uniform());
    }
    CHECK(attempt.session().state().solids[0].position.size() > 0);
    for (const Vec3& node : attempt.session().state().solids[0].position) {
        REQUIRE(node.allFinite());
    }
    const double removed = attempt.measure("lens.removed_mg");
    CHECK(std::isfinite(removed));
    CHECK(removed > 0.0);
}
