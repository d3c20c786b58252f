// SPDX-License-Identifier: GPL-3.0-or-later
// The groove exercise: each error raised, put right or not, by an instrument alone; and its silent twin.
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

TEST_CASE("too deep: raised near the posterior capsule, put right by lifting the tip") {
    Attempt attempt;
    drill(attempt, 0.25);
    CHECK(attempt.outcome("groove_too_deep") == "open");
    draw_back(attempt);
    attempt.hold(0.2, 1.0);
    const std::string outcome = attempt.outcome("groove_too_deep");
    CHECK((outcome == "recovered" || outcome == "near_miss"));
}

TEST_CASE("too deep: not put right when the tip stays") {
    Attempt attempt;
    drill(attempt, 0.25);
    attempt.hold(2.5, 2.0);
    CHECK(attempt.outcome("groove_too_deep") == "not_recovered");
    CHECK(attempt.result().at("osacss").at("items").at(1).at("score") == 1.0);
}

TEST_CASE("too deep: the twin that stops in time raises nothing") {
    Attempt attempt;
    drill(attempt, 0.8);
    attempt.hold(2.5, 2.0);
    draw_back(attempt);
    CHECK(attempt.outcome("groove_too_deep").empty());
}

TEST_CASE("iris: touched from the side, put right by drawing back, not put right by staying") {
    for (const bool back : {true, false}) {
        Attempt attempt;
        const double edge = attempt.session().eye().anatomy.pupil_radius;
        const double z = attempt.session().eye().anatomy.iris_z;
        attempt.appear(Vec3(0.0, 0.0, 3.0));
        attempt.move(Vec3(1.5, 1.0, 2.6), 6.0, 1.0);
        attempt.move(Vec3(edge - 0.1, 1.0, z), 4.0, 1.0);
        CHECK(attempt.measure("iris.touches") >= 1.0);
        if (back) {
            attempt.move(Vec3(1.5, 1.0, 2.6), 6.0, 1.0);
        }
        attempt.hold(1.5, 1.0);
        CHECK(attempt.outcome("iris_touched") == (back ? "recovered" : "not_recovered"));
    }
}

TEST_CASE("iris: the twin that turns back before the pupil's edge raises nothing") {
    Attempt attempt;
    const double edge = attempt.session().eye().anatomy.pupil_radius;
    attempt.appear(Vec3(0.0, 0.0, 3.0));
    attempt.move(Vec3(1.5, 1.0, 2.6), 6.0, 1.0);
    attempt.move(Vec3(edge - 1.3, 1.0, 2.2), 4.0, 1.0);
    attempt.move(Vec3(1.5, 1.0, 2.6), 6.0, 1.0);
    CHECK(attempt.outcome("iris_touched").empty());
}

TEST_CASE("pushing: without ultrasound the tip shifts the lens; drawing back puts it right, staying does not") {
    for (const bool back : {true, false}) {
        Attempt attempt;
        attempt.appear(Vec3(0.0, -1.5, 2.6));
        attempt.move(Vec3(0.0, -1.5, 1.2), 2.0, 1.0);
        for (double y = -1.5; y < 2.4 && attempt.outcome("pushing_the_lens").empty(); y += 0.1) {
            attempt.move(Vec3(0.0, y, 1.0), 2.0, 1.0);
        }
        CHECK(attempt.outcome("pushing_the_lens") == "open");
        if (back) {
            attempt.move(over_lens, 8.0, 1.0);
        }
        attempt.hold(6.0, 1.0);
        const std::string outcome = attempt.outcome("pushing_the_lens");
        CHECK((back ? outcome == "recovered" || outcome == "near_miss" : outcome == "not_recovered"));
    }
}

TEST_CASE("pushing: the twin that cuts its way does not shift the lens") {
    Attempt attempt;
    attempt.appear(Vec3(0.0, -1.5, 2.6));
    attempt.move(Vec3(0.0, -1.5, 1.6), 2.0, 3.0);
    attempt.move(Vec3(0.0, 2.0, 1.5), 2.0, 3.0);
    CHECK(attempt.outcome("pushing_the_lens").empty());
    CHECK(attempt.measure("lens.removed_mm3") > 0.2);
}

TEST_CASE("pedal at 2 removes nothing") {
    Attempt attempt;
    attempt.appear(Vec3(0.0, -1.5, 2.6));
    attempt.move(Vec3(0.0, -1.5, 1.8), 2.0, 2.0);
    attempt.move(Vec3(0.0, 2.0, 1.7), 4.0, 2.0);
    CHECK(attempt.measure("lens.removed_mm3") == 0.0);
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
