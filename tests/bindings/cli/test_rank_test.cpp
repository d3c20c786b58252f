// SPDX-License-Identifier: GPL-3.0-or-later
// Against values that are not ours: tables of the critical values of U, and the exact counts of small samples.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "cli/rank_test.hpp"

using namespace rhexis::cli;

namespace {

/// Two samples without ties of 8 values whose smaller U is `wanted`.
RankTest test_with_u(int wanted) {
    std::vector<double> a;
    std::vector<double> b;
    // b holds 1 to 8; each value of a is put over so many of them that the sum is `wanted`
    for (int i = 1; i <= 8; ++i) {
        b.push_back(i);
    }
    for (int i = 0; i < 8; ++i) {
        const int below = std::min(8, wanted);
        wanted -= below;
        a.push_back(below + 0.5 + 0.01 * i);
    }
    return mann_whitney(a, b);
}

}  // namespace

TEST_SUITE("rank test") {
    TEST_CASE("exact probabilities of small samples, counted by hand") {
        // of the C(6,3) = 20 orders of 3 and 3, one has U = 0 and one U = 1
        const std::array<double, 3> low{1, 2, 3};
        const std::array<double, 3> high{4, 5, 6};
        const RankTest apart = mann_whitney(low, high);
        CHECK(apart.exact);
        CHECK(apart.u == 0.0);
        CHECK(apart.p == doctest::Approx(2.0 / 20.0));
        const std::array<double, 3> mixed{1, 2, 4};
        const std::array<double, 3> rest{3, 5, 6};
        CHECK(mann_whitney(mixed, rest).p == doctest::Approx(4.0 / 20.0));
        CHECK(mann_whitney(rest, mixed).p == doctest::Approx(4.0 / 20.0));
    }

    TEST_CASE("critical values of U for 8 and 8, two-sided") {
        // tables of [MannWhitney1947] and later ones: 13 at 0.05, 7 at 0.01
        CHECK(test_with_u(13).u == 13.0);
        CHECK(test_with_u(13).p < 0.05);
        CHECK(test_with_u(14).p > 0.05);
        CHECK(test_with_u(7).p < 0.01);
        CHECK(test_with_u(8).p > 0.01);
    }

    TEST_CASE("with ties the normal approximation is used, and comes near the exact value") {
        const std::vector<double> a{1, 2, 2, 3, 4, 5, 6, 7};
        const std::vector<double> b{4, 6, 7, 8, 9, 10, 11, 12};
        const RankTest tied = mann_whitney(a, b);
        CHECK(!tied.exact);
        CHECK(tied.p == doctest::Approx(test_with_u(static_cast<int>(std::lround(tied.u))).p).epsilon(0.35));
    }

    TEST_CASE("nothing to tell apart") {
        const std::vector<double> same{3, 3, 3};
        CHECK(mann_whitney(same, same).p == 1.0);
        CHECK(mann_whitney({}, same).p == 1.0);
    }

    TEST_CASE("mean, deviation and correlation") {
        const std::vector<double> a{2, 4, 4, 4, 5, 5, 7, 9};
        CHECK(mean_of(a) == doctest::Approx(5.0));
        CHECK(deviation_of(a) == doctest::Approx(std::sqrt(32.0 / 7.0)));
        const std::vector<double> b{1, 2, 2, 2, 2.5, 2.5, 3.5, 4.5};
        CHECK(correlation_of(a, b) == doctest::Approx(1.0));
        CHECK(std::isnan(correlation_of(a, std::vector<double>(8, 1.0))));
    }
}
