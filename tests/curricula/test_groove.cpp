// SPDX-License-Identifier: GPL-3.0-or-later
// The groove exercise beyond its scenario tests (curricula/groove/tests): scores, its end, virtual surgeons.
#include <doctest/doctest.h>

#include <cmath>

#include "attempt.hpp"

using namespace rhexis;
using rhexis::test::Attempt;

namespace {

const Vec3 over_lens(0.0, 0.0, 3.0);

/// A hole straight down in the middle, by ultrasound, to a depth at which the tip is `rest` from the posterior capsule.
void drill(Attempt& attempt, double rest) {
    attempt.appear(over_lens);
    double z = over_lens.z();
    attempt.hold(0.1, 1.0);
    while (attempt.measure("phaco.tip_posterior_mm") > rest && z > -4.0) {
        z -= 0.02;
        attempt.move(Vec3(0.0, 0.0, z), 1.0, 3.0);
    }
}

void draw_back(Attempt& attempt) { attempt.move(over_lens, 8.0, 1.0); }

}  // namespace

TEST_CASE("the groove exercise observes all that its scores and errors need") {
    Attempt attempt;
    attempt.hold(0.05, 0.0);
    const nlohmann::json result = attempt.result();
    for (const nlohmann::json& item : result.at("osacss").at("items")) {
        CAPTURE(item.dump());
        CHECK(item.contains("id"));
    }
    // Nothing was done: what was never tried is not scored, the depth of the groove is.
    CHECK(result.at("measures").at("T9.depth") == 0.0);
}

TEST_CASE("too deep and not put right: its item is scored 1") {
    Attempt attempt;
    drill(attempt, 0.25);
    attempt.hold(2.5, 2.0);
    CHECK(attempt.outcome("groove_too_deep") == "not_recovered");
    CHECK(attempt.result().at("osacss").at("items").at(1).at("score") == 1.0);
}

TEST_CASE("leaving the eye after work ends the exercise, and the report says what was not reached") {
    Attempt attempt;
    drill(attempt, 4.0);
    draw_back(attempt);
    attempt.withdraw();
    CHECK(attempt.host().finished());
    CHECK(attempt.result().at("completed") == false);
    CHECK(attempt.result().at("advice").size() > 0);
}

TEST_CASE("the first seconds of an expert and of a novice: they reach the lens and cut") {
    for (const char* surgeon : {"expert", "novice"}) {
        Attempt attempt(surgeon, 3);
        attempt.run(12.0);
        CAPTURE(surgeon);
        CHECK(attempt.measure("lens.removed_mm3") > 0.3);
        CHECK(attempt.result().at("steps").at(0).at("completed") == true);
    }
}
