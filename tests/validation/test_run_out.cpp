// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a capsulorhexis run out, in short; `rhexis bench run_out` is the study.
#include <doctest/doctest.h>

#include <cmath>

#include "scenes/capsule_load.hpp"
#include "scenes/proportions.hpp"
#include "scenes/retraction.hpp"
#include "scenes/run_out.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

TEST_SUITE("run-out") {
    TEST_CASE("what is missing of the viscoelastic lifts the lens, pulls on zonules and stretches the capsule") {
        CapsuleLoad last;
        last.lift = -1.0;
        for (const double fill : {1.0, 0.6, 0.2}) {
            CapsuleScene scene(68.0, {}, {});
            scene.sheet().support.push = push_of_vitreous({fill, 20.0});
            for (int i = 0; i < 80; ++i) {
                REQUIRE(scene.step());
            }
            const CapsuleLoad load = capsule_load(scene.model(), scene.sheet());
            CHECK(load.lift > last.lift + 0.3);
            CHECK(load.zonules > last.zonules + 1e4);
            CHECK(load.tension_radial > last.tension_radial + 200.0);
            CHECK(load.tension_circular > last.tension_circular + 200.0);
            last = load;
        }
    }

    TEST_CASE("a round cut springs open as far as was measured in eyes, and less far the older they are") {
        // 47 adults: cut 5.67 mm wide, open 5.99 (5.8 %), standard deviation 0.31, less with age [Tan2025]; the tension
        // of the zonules is fitted to that at 68 years
        double last = 1.0;
        for (const double age : {45.0, 68.0, 90.0}) {
            const Retraction cut = retraction(age, 5.67);
            CAPTURE(age);
            REQUIRE(cut.closed);
            CHECK(cut.cut == doctest::Approx(5.67).epsilon(0.03));  // it follows the mesh's edges
            const double growth = cut.open / cut.cut - 1.0;
            CAPTURE(growth);
            CHECK(growth > 0.02);
            CHECK(growth < 0.11);
            CHECK((age == 68.0 ? std::abs(growth - 0.058) < 0.006 : true));
            CHECK(growth < last);
            last = growth;
        }
    }

    TEST_CASE("fill and pressure act by one push alone") {
        CHECK(push_of_vitreous({1.0, 20.0}) == doctest::Approx(0.0));
        CHECK(push_of_vitreous({0.2, 20.0}) == doctest::Approx(149.3e3).epsilon(1e-3));  // 70 mm^2, 0.8 of 2,666 Pa
        CHECK(push_of_vitreous({0.2, 10.0}) == doctest::Approx(push_of_vitreous({0.6, 20.0})));
        CHECK(push_of_vitreous({0.2, 5.0}) == doctest::Approx(push_of_vitreous({0.8, 20.0})));
    }

    TEST_CASE("the same pulls from the same state: farther out in a shallow chamber than in a full one") {
        RunOutTrial trial(68.0, 1, 800);
        CHECK(std::abs(trial.start_radius() - planned_radius) < 0.5);
        const RunOutResult full = trial.run({1.0, 20.0}, steady_pulls(10.0));
        const RunOutResult shallow = trial.run({0.2, 20.0}, steady_pulls(10.0));
        const RunOutResult again = trial.run({1.0, 20.0}, steady_pulls(10.0));
        CHECK(full.fate == Fate::kept);
        CHECK(shallow.radius > full.radius + 0.5);
        CHECK(again.radius == full.radius);
    }

    TEST_CASE("beginners differ, and each is the same again") {
        CHECK(pulls_of_beginner(1) == pulls_of_beginner(1));
        CHECK(pulls_of_beginner(1) != pulls_of_beginner(2));
        double sum = 0.0;
        for (int seed = 1; seed <= 1000; ++seed) {
            sum += pulls_of_beginner(static_cast<std::uint64_t>(seed))[0];
        }
        CHECK(sum / 1000.0 == doctest::Approx(10.0).epsilon(0.1));
    }

    TEST_CASE("Wilson's interval and Fisher's test against tables") {
        CHECK(wilson(8, 10).low == doctest::Approx(0.4902).epsilon(1e-3));
        CHECK(wilson(8, 10).high == doctest::Approx(0.9433).epsilon(1e-3));
        CHECK(wilson(0, 40).low == 0.0);
        CHECK(wilson(0, 40).high == doctest::Approx(0.0876).epsilon(1e-3));
        CHECK(fisher(3, 4, 1, 4) == doctest::Approx(34.0 / 70.0));  // the lady tasting tea
        CHECK(fisher(1, 12, 9, 12) == doctest::Approx(0.002759).epsilon(1e-3));
        CHECK(fisher(5, 10, 5, 10) == doctest::Approx(1.0));
    }
}
