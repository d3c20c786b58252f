// SPDX-License-Identifier: GPL-3.0-or-later
// Against the worked examples of the papers that the formulas come from.
#include <doctest/doctest.h>

#include <cmath>

#include "records/agreement.hpp"

using namespace rhexis::records;
using doctest::Approx;

TEST_SUITE("agreement") {
    TEST_CASE("ICC of the worked example of Shrout and Fleiss 1979, table 2 and 4") {
        const Scores scores = {{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
        std::string why;
        const std::optional<Correlation> found = intraclass(scores, why);
        REQUIRE(found.has_value());
        CHECK(found->targets == 6);
        CHECK(found->judges == 4);
        CHECK(std::round(100.0 * found->single) == 29.0);
        CHECK(std::round(100.0 * found->average) == 62.0);
        // BMS 11.24, JMS 32.49, EMS 1.02, from their table 3
        CHECK(found->single == Approx((11.24 - 1.02) / (11.24 + 3 * 1.02 + 4 * (32.49 - 1.02) / 6)).epsilon(2e-3));
    }

    TEST_CASE("ICC is 1 for judges who agree, and less when one is always milder") {
        std::string why;
        CHECK(intraclass({{1, 1}, {3, 3}, {5, 5}}, why)->single == Approx(1.0));
        const std::optional<Correlation> milder = intraclass({{1, 2}, {3, 4}, {4, 5}}, why);
        CHECK(milder->single < 0.95);
        CHECK(milder->single > 0.5);
        CHECK(milder->average > milder->single);
        // against each other
        const std::optional<Correlation> against = intraclass({{1, 3}, {3, 1}, {2, 3}, {3, 3}}, why);
        REQUIRE(against.has_value());
        CHECK(against->single == Approx(-0.8));
        CHECK_FALSE(intraclass({{1, 3}, {3, 1}, {1, 3}, {3, 1}}, why).has_value());
        CHECK(why == "the attempts do not differ");
    }

    TEST_CASE("where there is no ICC, it says why") {
        std::string why;
        CHECK_FALSE(intraclass({}, why).has_value());
        CHECK(why == "nothing that all have scored");
        CHECK_FALSE(intraclass({{1, 2, 3}}, why).has_value());
        CHECK(why == "only one attempt that all have scored");
        CHECK_FALSE(intraclass({{1}, {2}}, why).has_value());
        CHECK(why == "too few judges");
        CHECK_FALSE(intraclass({{5, 5}, {5, 5}, {5, 5}}, why).has_value());
        CHECK(why == "all scores are the same");
    }

    TEST_CASE("judges of whom each gives one score to all: no correlation, and a number") {
        std::string why;
        const std::optional<Correlation> found = intraclass({{4, 5}, {4, 5}, {4, 5}}, why);
        REQUIRE(found.has_value());
        CHECK(found->single == Approx(0.0));
    }

    TEST_CASE("limits of agreement of the peak flow meters of Bland and Altman 1986") {
        const std::vector<double> large = {494, 395, 516, 434, 476, 557, 413, 442, 650,
                                           433, 417, 656, 267, 478, 178, 423, 427};
        const std::vector<double> mini = {512, 430, 520, 428, 500, 600, 364, 380, 658,
                                          445, 432, 626, 260, 477, 259, 350, 451};
        const std::optional<Limits> found = limits_of_agreement(large, mini);
        REQUIRE(found.has_value());
        CHECK(found->n == 17);
        CHECK(found->bias == Approx(-2.1).epsilon(0.02));
        CHECK(found->sd == Approx(38.8).epsilon(1e-3));
        CHECK(found->high - found->low == Approx(2 * 1.96 * 38.8).epsilon(1e-3));
        CHECK_FALSE(limits_of_agreement(std::vector<double>{1.0}, std::vector<double>{2.0}).has_value());
        CHECK_FALSE(limits_of_agreement({}, {}).has_value());
    }
}
