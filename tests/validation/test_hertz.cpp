// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid ball on a half-space: force and patch against the closed form of Hertz. Linear tetrahedra lock: they come
// nearer with every mesh, but are still 19 % too stiff on the finest here. Smoothed over edges they are within 3 %.
#include <doctest/doctest.h>

#include <cmath>

#include "scenes/hertz.hpp"

using namespace rhexis;

namespace {

/// Error of the force [share] on the finest of three meshes; falls from mesh to mesh.
double error_on_finest(Formulation formulation) {
    const scenes::HertzCase problem;
    double last = 1.0;
    for (const int n : {5, 7, 9}) {
        const scenes::HertzResult result = scenes::press_ball(problem, n, formulation);
        const double error = result.force / problem.force() - 1.0;
        MESSAGE(result.tetrahedra << " tetrahedra: " << 100.0 * error << " % above the force of Hertz");
        CHECK(result.rollbacks == 0);
        CHECK(result.change < 1e-6);
        // patches of tetrahedra are not symmetric where the mesh is
        CHECK(result.sideways < (formulation == Formulation::linear ? 1e-6 : 1e-3) * result.force);
        CHECK(std::abs(result.patch - problem.patch()) < 1.5 * result.spacing);
        CHECK(std::abs(error) < last);
        last = std::abs(error);
    }
    return last;
}

}  // namespace

TEST_SUITE("validation") {
    TEST_CASE("a ball pressed into a large body is pushed back by the force of Hertz") {
        CHECK(error_on_finest(Formulation::edge_smoothed) < 0.05);
    }

    TEST_CASE("linear tetrahedra come to the force of Hertz from above, slowly") {
        CHECK(error_on_finest(Formulation::linear) < 0.25);
    }
}
