// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study_cohort.hpp"

#include <doctest/doctest.h>

using namespace rhexis::cli;
using nlohmann::json;

namespace {

GroupScores group(const char* name, std::vector<double> completed) { return {name, 8, std::move(completed)}; }

}  // namespace

TEST_SUITE("study cohort") {
    TEST_CASE("groups part where their scores do, and stay together where they do not") {
        const json cuts =
            cuts_of({group("a", {0.30, 0.32, 0.34, 0.36, 0.38}), group("b", {0.60, 0.62, 0.64, 0.66, 0.68}),
                     group("c", {0.80, 0.82, 0.86, 0.88, 0.90}), group("d", {0.81, 0.83, 0.85, 0.87, 0.91})});
        REQUIRE(cuts.size() == 3);
        CHECK(cuts[0] == json({{"from", 0.0}, {"groups", {"a"}}, {"n", 5}}));
        CHECK(cuts[1]["groups"] == json({"b"}));
        CHECK(cuts[1]["from"].get<double>() == doctest::Approx(0.49));
        CHECK(cuts[2]["groups"] == json({"c", "d"}));
        CHECK(cuts[2]["from"].get<double>() == doctest::Approx(0.74));
        CHECK(cuts[2]["n"] == 10);
    }

    TEST_CASE("a cut lies where fewest are on the wrong side of it") {
        const json cuts =
            cuts_of({group("a", {0.2, 0.3, 0.4, 0.5, 0.6, 0.9}), group("d", {0.5, 0.8, 0.85, 0.9, 0.95, 0.97})});
        REQUIRE(cuts.size() == 2);
        CHECK(cuts[1]["from"].get<double>() == doctest::Approx(0.7));
    }

    TEST_CASE("no cut where groups do not differ, where the order is turned round, or where too few came to the end") {
        CHECK(cuts_of({group("a", {0.5, 0.6, 0.7, 0.8}), group("d", {0.55, 0.65, 0.75, 0.85})}).size() == 1);
        CHECK(cuts_of({group("a", {0.8, 0.82, 0.84, 0.86}), group("d", {0.2, 0.22, 0.24, 0.26})}).size() == 1);
        const json few = cuts_of({group("a", {0.1, 0.2}), group("d", {0.8, 0.82, 0.84, 0.86})});
        REQUIRE(few.size() == 1);
        CHECK(few[0]["groups"] == json({"d"}));
        CHECK(cuts_of({group("a", {}), group("d", {})}).empty());
    }
}
