// SPDX-License-Identifier: GPL-3.0-or-later
// An implant folded into a cartridge, and a run that begins with it.
#include <doctest/doctest.h>

#include <algorithm>

#include "flow/tube.hpp"
#include "session/implant_fold.hpp"
#include "support/folder.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

const std::map<std::string, double> coarse{{"implant.triangles", 400.0}};

double value_of(const Session& session, const char* name) {
    const ObservationSchema& schema = session.schema();
    const auto found =
        std::find_if(schema.begin(), schema.end(), [&](const auto& entry) { return entry.name == name; });
    REQUIRE(found != schema.end());
    return session.observation().values[static_cast<std::size_t>(found - schema.begin())];
}

}  // namespace

TEST_SUITE("implant folds") {
    TEST_CASE(
        "the lens ends in the bore, at rest, a session begins with it and with no other lens, and its plunger pushes "
        "it out") {
        Result<ImplantFold> made = ImplantFold::create(folding_scene(coarse));
        REQUIRE_MESSAGE(made.ok(), made.error().text());
        ImplantFold& fold = made.value();
        double most = 0.0;
        while (!fold.done()) {
            REQUIRE(fold.step().ok());
            most = std::max(most, fold.progress().deepest);
        }
        CHECK(most < 0.05);
        const Result<PreparedState> result = fold.result();
        REQUIRE_MESSAGE(result.ok(), result.error().text());
        const Folder folder;
        REQUIRE(write_state(folder / "lens.rhxs", result.value()).ok());
        Result<Session> session = create_session(folding_scene(coarse), 1, folder / "lens.rhxs");
        REQUIRE_MESSAGE(session.ok(), session.error().text());
        const ShellState lens = session.value().state().shells[0];
        CHECK(lens.loaded);
        const Cartridge& cartridge = *session.value().world().tools[0].cartridge;
        for (const Vec3& place : lens.position) {
            CHECK(tube_distance(cartridge.bore, cartridge.bore.pose.to_body(place)).distance > 0.1);
        }
        const Result<Session> other = create_session(folding_scene({}), 1, folder / "lens.rhxs");
        REQUIRE_FALSE(other.ok());
        CHECK(other.error().text().find("implant.triangles 400 there, 743 here") != std::string::npos);
        DeviceSample sample;
        session.value().step({&sample, 1}, {});
        CHECK(session.value().state().shells[0].loaded);  // nobody has brought it in
        sample.present = true;
        sample.pose.position = Vec3(0.0, 0.0, 1.0);
        const Vec3 before = lens.position[0];
        for (int i = 0; i < 5; ++i) {
            session.value().step({&sample, 1}, {});
        }
        const ShellState& brought = session.value().state().shells[0];
        CHECK_FALSE(brought.loaded);
        CHECK((brought.position[0] - before - sample.pose.position).norm() < 0.02);
        const double stroke = cartridge.stroke;
        constexpr double speed = 5.0;  // of the plunger [mm/s]
        while (sample.jaw < 1.0) {
            sample.jaw = std::min(1.0, sample.jaw + speed * session.value().scene().step_s / stroke);
            session.value().step({&sample, 1}, {});
        }
        CHECK(value_of(session.value(), "implant.delivered") == 1.0);
        CHECK(value_of(session.value(), "injector.jammed") == 0.0);
        CHECK(value_of(session.value(), "injector.plunger_mm") == doctest::Approx(stroke));
    }
}
