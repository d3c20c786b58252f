// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/least_cut.hpp"

#include <doctest/doctest.h>

#include <algorithm>


#include "base/rng.hpp"

using namespace rhexis;

namespace {

/// Over every way to put the free cells on a side.
double least_by_trying(const std::vector<Joint>& joints, const std::vector<CutSide>& sides) {
    double least = 1e300;
    for (unsigned choice = 0; choice < 1U << sides.size(); ++choice) {
        bool allowed = true;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const bool first = (choice >> i & 1U) != 0;
            allowed = allowed && sides[i] != (first ? CutSide::second : CutSide::first);
        }
        double sum = 0.0;
        for (const Joint& joint : joints) {
            sum += (choice >> joint.a & 1U) != (choice >> joint.b & 1U) ? joint.strength : 0.0;
        }
        least = allowed ? std::min(least, sum) : least;
    }
    return least;
}

}  // namespace

TEST_SUITE("least cut") {
    TEST_CASE("a chain parts at its weakest joint") {
        const std::vector<CutSide> sides{CutSide::first, CutSide::free, CutSide::free, CutSide::second};
        const LeastCut cut = least_cut({{0, 1, 3.0}, {1, 2, 0.5}, {2, 3, 2.0}}, sides);
        CHECK(cut.strength == doctest::Approx(0.5));
        CHECK(cut.joints == std::vector<int>{1});
        CHECK(least_cut({{0, 1, 3.0}, {2, 3, 2.0}}, sides).strength == 0.0);
        CHECK(least_cut({}, sides).strength == 0.0);
        CHECK(least_cut({{0, 1, 1.0}}, {CutSide::first, CutSide::free}).strength == 0.0);
    }

    TEST_CASE("on random networks the same as trying every cut") {
        Rng rng(1, "least cut");
        for (int run = 0; run < 200; ++run) {
            std::vector<CutSide> sides(9, CutSide::free);
            sides[0] = sides[1] = CutSide::first;
            sides[7] = sides[8] = CutSide::second;
            std::vector<Joint> joints;
            for (int a = 0; a < 9; ++a) {
                for (int b = a + 1; b < 9; ++b) {
                    if (rng.uniform() < 0.4) {
                        joints.push_back({a, b, rng.uniform()});
                    }
                }
            }
            const LeastCut cut = least_cut(joints, sides);
            CHECK(cut.strength == doctest::Approx(least_by_trying(joints, sides)).epsilon(1e-9));
            double sum = 0.0;
            for (const int joint : cut.joints) {
                sum += joints[joint].strength;
            }
            CHECK(sum == doctest::Approx(cut.strength).epsilon(1e-9));
        }
    }
}
