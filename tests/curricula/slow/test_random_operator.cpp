// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands anywhere, any pedal, in every exercise. Ten minutes each: scripts/dev/random_operator.py.
#include <doctest/doctest.h>

#include <cmath>

#include "../attempt.hpp"
#include "kernel/session/operate.hpp"
#include "scenes/sheet_accounts.hpp"

using namespace rhexis;
using rhexis::test::Attempt;
using rhexis::test::tissue_mass;

namespace {

std::uint64_t survive(const std::string& exercise, const std::map<std::string, std::string>& patient) {
    std::map<std::string, std::string> set = patient;
    set["time_limit_s"] = "7200";
    set["patient.tetrahedra"] = "800";
    Attempt attempt("random", 11, set, exercise);
    const double mass = tissue_mass(attempt.session());
    attempt.run(40.0);
    CHECK(attempt.session().time_s() > 39.0);
    CHECK(tissue_mass(attempt.session()) == doctest::Approx(mass).epsilon(1e-12));
    for (const Vec3& node : attempt.session().state().solids[0].position) {
        REQUIRE(node.allFinite());
    }
    MESSAGE(exercise << ": " << attempt.rollbacks() << " steps redone, " << attempt.result().at("events").size()
                     << " errors");
    CHECK(attempt.result().at("events").size() > 0);
    return attempt.session().state_hash();
}

struct End {
    double time_s = 0.0;
    std::uint64_t hash = 0;
};

/// The capsule is looked at after every step.
End survive_tearing(std::uint64_t seed, double seconds) {
    Attempt attempt("random", seed, {{"time_limit_s", "7200"}}, "capsulorhexis");
    const MembraneModel& model = attempt.session().world().membranes[0];
    const scenes::SheetAccounts accounts(model);
    scenes::RandomTears seen;
    std::shared_ptr<const MembraneSheet> sheet = model.sheet;
    while (attempt.session().time_s() < seconds && attempt.step()) {
        const MembraneState& state = attempt.session().state().membranes[0];
        const std::string fault = state.sheet == sheet ? accounts.motion_fault(state) : accounts.look(state, seen);
        REQUIRE_MESSAGE(fault.empty(), fault);
        sheet = state.sheet;
    }
    const MembraneState& end = attempt.session().state().membranes[0];
    CHECK(accounts.descent_fault(end).empty());
    CHECK(attempt.measure("rhexis.torn_mm") > 3.0);
    CHECK(seen.most_cosine <= 0.0);
    CHECK(seen.most_of_bound < 1.0);
    CHECK(std::max({seen.area_off, seen.mass_off, seen.torn_off, seen.energy_off}) < 1e-9);
    MESSAGE("capsulorhexis " << seed << ": " << attempt.session().time_s() << " s, " << attempt.rollbacks()
                             << " steps redone, " << attempt.result().at("events").size() << " errors, torn "
                             << attempt.measure("rhexis.torn_mm") << " mm, at most " << seen.most_triangles
                             << " triangles of " << model.sheet->mesh.triangles.size() << ", smallest angle "
                             << seen.least_angle << " degrees");
    return {attempt.session().time_s(), attempt.session().state_hash()};
}

}  // namespace

TEST_CASE("a random operator: finite numbers, no mass lost, the same end twice") {
    for (const char* exercise : {"groove", "phaco_sculpt", "phaco_crack", "phaco_quadrants"}) {
        CAPTURE(exercise);
        CHECK(survive(exercise, {}) == survive(exercise, {}));
    }
}

TEST_CASE("a random operator in a white cataract, a brunescent and a soft lens") {
    survive("phaco_sculpt", {{"patient.cortical_opacity", "1"}});
    survive("phaco_sculpt", {{"patient.cataract", "NO6"}, {"patient.age", "82"}});
    survive("phaco_sculpt", {{"patient.cataract", "NO1"}, {"patient.age", "55"}});
}

TEST_CASE(
    "a random operator on the anterior capsule: the sheet stays sound, nothing of it is lost, the same end twice") {
    CHECK(survive_tearing(301, 40.0).hash == survive_tearing(301, 40.0).hash);
    double passed = 0.0;  // an attempt that ends early is followed by another
    for (std::uint64_t seed = 301; passed < 599.9; ++seed) {
        passed += survive_tearing(seed, 600.0 - passed).time_s;
    }
}
