// SPDX-License-Identifier: GPL-3.0-or-later
// What of the eye a surgeon sees through the pupil.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "session/session.hpp"

using namespace rhexis;

namespace {

Percept first_look(double pupil_mm) {
    SceneDescription scene;
    scene.tissues = {"bag", "capsule", "iris", "cornea", "chamber", "cortex"};
    scene.instruments = {"ia_tip"};
    scene.patient.pupil_mm = pupil_mm;
    return Session::create(scene, 1).value().percept();
}

/// Greatest distance from the axis at which cortex shows, and the greatest share of a sector [mm, 1].
std::pair<double, double> cortex_seen(const Percept& percept) {
    double out = 0.0;
    double share = 0.0;
    for (const Landmark& mark : percept.landmarks) {
        if (mark.visible && mark.name.starts_with("cortex_")) {
            out = std::max(out, mark.position.head<2>().norm());
            share = std::max(share, mark.size);
        }
    }
    return {out, share};
}

}  // namespace

TEST_CASE(
    "Cortex is seen where the iris leaves it free: to the fornix through a wide pupil, on the back through a narrow") {
    const auto [wide_out, wide_share] = cortex_seen(first_look(9.0));
    CHECK(wide_out > 4.0);
    CHECK(wide_share == doctest::Approx(1.0));
    const auto [narrow_out, narrow_share] = cortex_seen(first_look(7.0));
    CHECK(narrow_out > 3.0);
    CHECK(narrow_out < 3.5);
    CHECK(narrow_share == doctest::Approx(2.0 / 3.0));
    const auto [least_out, least_share] = cortex_seen(first_look(5.0));
    CHECK(least_out < 2.5);
    CHECK(least_share == doctest::Approx(1.0 / 3.0));
}
