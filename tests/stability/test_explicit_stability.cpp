// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "scenes/bodies.hpp"
#include "scenes/explicit_trials.hpp"

using namespace rhexis;

TEST_SUITE("stability") {
    TEST_CASE("T1: explicit bodies thrown together at random, flat or mirrored come back, and never gain energy") {
        SolidModel lens = scenes::default_eye(1000).lens;
        SolidModel cube = scenes::cube(4, 2.0, 3000.0, 0.45);
        cube.damping_mass = lens.damping_mass;
        cube.damping_stiffness = lens.damping_stiffness;
        for (const SolidModel& model : {lens, cube}) {
            for (const scenes::BadStart start :
                 {scenes::BadStart::random, scenes::BadStart::flat, scenes::BadStart::mirrored}) {
                CAPTURE(model.name);
                CAPTURE(static_cast<int>(start));
                const scenes::Recovery recovery = scenes::recover(model, start, 1.0);
                CHECK(recovery.finite);
                CHECK(recovery.inverted_at_start > 0.4);
                CHECK(recovery.inverted_at_end == 0.0);
                CHECK(recovery.largest_rise < 1e-6);
                CHECK(recovery.energy_left < 1e-6);
            }
        }
    }

    TEST_CASE("T3, T4: whatever Poisson's ratio and slivers do to it, the stated stable step is the true one") {
        for (const double nu : {0.3, 0.45, 0.49, 0.499}) {
            for (const double sliver : {1.0, 0.05}) {
                CAPTURE(nu);
                CAPTURE(sliver);
                SolidModel model = scenes::cube(3, 2.0, 3000.0, nu);
                scenes::flatten_one(model, sliver);
                const scenes::Limit limit = scenes::probe_limit(model);
                CHECK(limit.step > 0.0);
                CHECK(limit.below);
                CHECK(limit.beyond);
            }
        }
    }

    TEST_CASE("T17: an explicit lens that loses its elements at random, to the last, ends quietly") {
        const scenes::Deletion deletion = scenes::delete_all(scenes::default_eye(1000).lens, 5, 20);
        CHECK(deletion.finite);
        CHECK(deletion.steps >= 3900);
        CHECK(deletion.mass_error < 1e-12);
        CHECK(deletion.smallest_step > 0.6);
        // free fall for the time it takes is the fastest that anything may get
        CHECK(deletion.fastest < 9810.0 * 0.5);
    }

    TEST_CASE("T20: a free explicit body keeps its momentum to the rounding of float forces") {
        const scenes::Flight flight = scenes::fly(scenes::cube(3, 2.0, 3000.0, 0.45), 5000, 0.8);
        CHECK(flight.linear_drift < 1e-8);
        CHECK(flight.angular_drift < 1e-8);
    }

    TEST_CASE("T21: 100,000 undamped steps in float neither heat nor cool") {
        const scenes::Flight flight = scenes::fly(scenes::cube(2, 2.0, 3000.0, 0.45), 100000, 0.5);
        CHECK(std::abs(flight.energy_drift) < 0.01);
    }
}
