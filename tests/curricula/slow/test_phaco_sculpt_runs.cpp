// SPDX-License-Identifier: GPL-3.0-or-later
// Whole attempts at the cross.
#include <doctest/doctest.h>

#include <cmath>

#include "../attempt.hpp"

using namespace rhexis;
using rhexis::test::Attempt;

namespace {

int errors_recovered(Attempt& attempt) {
    int recovered = 0;
    for (const nlohmann::json& event : attempt.result().at("events")) {
        recovered += event.at("recovered") == true ? 1 : 0;
    }
    return recovered;
}

}  // namespace

TEST_CASE("an expert sculpts two grooves across each other, long and deep enough, clear of the posterior capsule") {
    Attempt attempt("expert", 101, {}, "phaco_sculpt");
    double nearest = 10.0;
    while (attempt.session().time_s() < 300.0 && attempt.step()) {
        const double distance = attempt.measure("phaco.tip_posterior_mm");
        nearest = std::isnan(distance) ? nearest : std::min(nearest, distance);
    }
    CHECK(attempt.result().at("completed") == true);
    CHECK(attempt.session().time_s() < 240.0);
    CHECK(attempt.measure("grooves.count") >= 2.0);
    CHECK(std::abs(attempt.measure("grooves.angle_deg") - 90.0) <= 10.0);
    for (const char* groove : {"groove_1.", "groove_2."}) {
        CHECK(attempt.measure(std::string(groove).append("length_mm")) >= 4.0);
        CHECK(attempt.measure(std::string(groove).append("depth_share")) >= 0.6);
    }
    CHECK(nearest > 0.0);
}

TEST_CASE("without ultrasound the same hands remove nothing") {
    Attempt attempt("expert", 101, {}, "phaco_sculpt");
    attempt.limit_pedal(2.0);
    attempt.run(60.0);
    CHECK(attempt.measure("phaco.path_mm") > 20.0);
    CHECK(attempt.measure("lens.removed_mm3") == 0.0);
    CHECK(attempt.measure("grooves.count") == 0.0);
}

TEST_CASE("a novice whose recovery is switched off puts no error right") {
    Attempt attempt("novice", 102, {{"surgeon.recovery", "0"}}, "phaco_sculpt");
    attempt.run(300.0);
    CHECK(attempt.result().at("events").size() > 0);
    CHECK(errors_recovered(attempt) == 0);
}
