// SPDX-License-Identifier: GPL-3.0-or-later
// Thin shells through large rotations against closed forms and published tables [Sze2004]; the same on more meshes, and
// with other plates, in docs/implant.md.
#include <doctest/doctest.h>

#include <cmath>

#include "physics/shell/shell_statics.hpp"
#include "scenes/shell_problems.hpp"
#include "scenes/shells.hpp"

using namespace rhexis;
using scenes::GridCut;
using scenes::ShellProblem;

namespace {

struct Outcome {
    double worst = HUGE_VAL;  ///< relative error over all rows and measures that are not zero
    int iterations = 0;
};

Outcome solve(const ShellProblem& problem) {
    ShellStatics statics = std::move(ShellStatics::create(problem.model)).value();
    ShellState state = rest_state(problem.model);
    Outcome outcome{0.0, 0};
    double factor = 0.0;
    for (const ShellProblem::Row& row : problem.reference) {
        const ShellStaticReport report = statics.load_to(problem.load, factor, row.factor, {}, state);
        REQUIRE(report.converged);
        CHECK(report.negative_pivots == 0);
        outcome.iterations += report.iterations;
        factor = row.factor;
        const std::array<double, 2> value = problem.measure(state);
        for (std::size_t k = 0; k < 2; ++k) {
            if (std::abs(row.measure[k]) > 1e-12) {
                outcome.worst = std::max(outcome.worst, std::abs(value[k] / row.measure[k] - 1.0));
            }
        }
    }
    return outcome;
}

/// Load factor at which the straight column's tangent stops being positive definite.
double buckling(const ShellProblem& problem) {
    ShellStatics statics = std::move(ShellStatics::create(problem.model)).value();
    double stable = 0.5;
    double unstable = 1.5;
    for (int k = 0; k < 16; ++k) {
        const double factor = 0.5 * (stable + unstable);
        ShellState state = rest_state(problem.model);
        REQUIRE(statics.equilibrate(problem.load, factor, {}, state).converged);
        (statics.negative_pivots(state) == 0 ? stable : unstable) = factor;
    }
    return stable;
}

}  // namespace

TEST_SUITE("shells") {
    TEST_CASE("a strip bent by an end shear is the elastica") {
        CHECK(solve(scenes::cantilever_shear(16, 1)).worst < 0.003);
        CHECK(solve(scenes::cantilever_shear(64, 4)).worst < 0.0015);  // the table's own digits
    }

    TEST_CASE("a strip under an end moment rolls up to a full circle") {
        const double coarse = solve(scenes::cantilever_moment(16, 2)).worst;
        const double fine = solve(scenes::cantilever_moment(32, 4)).worst;
        CHECK(fine < 0.005);
        CHECK(fine < 0.3 * coarse);
    }

    TEST_CASE("a slit ring, flat at first, is lifted along the table, in few iterations (T9)") {
        const Outcome coarse = solve(scenes::slit_ring(30, 4));
        const Outcome fine = solve(scenes::slit_ring(62, 6));  // 744 triangles
        CHECK(fine.worst < 0.03);
        CHECK(fine.worst < 0.5 * coarse.worst);
        CHECK(fine.iterations < 60);  // 8 loads
    }

    TEST_CASE("an open hemisphere is pulled and pushed along the table") {
        const Outcome coarse = solve(scenes::open_hemisphere(12, 12, GridCut::one_way));
        const Outcome fine = solve(scenes::open_hemisphere(20, 19, GridCut::one_way));  // 760 triangles
        CHECK(fine.worst < 0.03);
        CHECK(fine.worst < 0.5 * coarse.worst);
    }

    TEST_CASE("a column buckles under Euler's load") {
        CHECK(buckling(scenes::euler_column(16, 1)) == doctest::Approx(1.0).epsilon(0.01));
    }

    TEST_CASE("a whole load on a flat strip at once is found, by as many loads between as it takes (T9)") {
        const ShellProblem problem = scenes::slit_ring(30, 4);
        ShellStatics statics = std::move(ShellStatics::create(problem.model)).value();
        ShellState at_once = rest_state(problem.model);
        REQUIRE(statics.load_to(problem.load, 0.0, 1.0, {}, at_once).converged);
        ShellState by_rows = rest_state(problem.model);
        double factor = 0.0;
        for (const ShellProblem::Row& row : problem.reference) {
            REQUIRE(statics.load_to(problem.load, factor, row.factor, {}, by_rows).converged);
            factor = row.factor;
        }
        CHECK(problem.measure(at_once)[0] == doctest::Approx(problem.measure(by_rows)[0]).epsilon(1e-5));
    }

    TEST_CASE("the implant's optic is folded past three quarters of half a turn, in few iterations a load") {
        const scenes::FoldedOptic optic = scenes::folded_optic(743);
        ShellStatics statics = std::move(ShellStatics::create(optic.implant.model)).value();
        ShellState state = rest_state(optic.implant.model);
        double reached = 0.0;
        for (const double force : {1e4, 2e4, 3e4, 4e4, 8e4}) {
            const ShellStaticReport report = statics.load_to(optic.load, reached, force, {}, state);
            REQUIRE(report.converged);
            CHECK(report.iterations < 10);
            CHECK(report.negative_pivots == 0);
            reached = force;
        }
        CHECK(scenes::fold_degrees(optic, state) > 135.0);
        CHECK(scenes::fold_degrees(optic, state) < 150.0);
    }

    TEST_CASE("a hinged roof snaps through: the path passes both limit points (T10)") {
        // load factor 0.742 at W 11.3, then 0.173 at 19.9 [Sze2004]
        const ShellProblem problem = scenes::hinged_roof(12, 12.7);
        ShellStatics statics = std::move(ShellStatics::create(problem.model)).value();
        ShellPath path{rest_state(problem.model), 0.0, {}};
        double upper = 0.0;
        double lower = 1.0;
        double upper_at = 0.0;
        double lower_at = 0.0;
        double w = 0.0;
        int unstable = 0;
        for (int step = 0; step < 60 && w < 29.0; ++step) {
            const ShellStaticReport report = statics.follow(problem.load, 8.0, {}, path);
            REQUIRE(report.converged);
            w = problem.measure(path.state)[0];
            unstable += statics.negative_pivots(path.state) > 0 ? 1 : 0;
            if (w < 15.0 && path.factor > upper) {
                upper = path.factor;
                upper_at = w;
            }
            if (w > 15.0 && path.factor < lower) {
                lower = path.factor;
                lower_at = w;
            }
        }
        CHECK(w >= 29.0);
        CHECK(unstable > 3);
        CHECK(upper == doctest::Approx(0.742).epsilon(0.03));
        CHECK(upper_at == doctest::Approx(11.3).epsilon(0.1));
        CHECK(lower == doctest::Approx(0.173).epsilon(0.05));
        CHECK(lower_at == doctest::Approx(19.9).epsilon(0.05));
    }
}
