// SPDX-License-Identifier: GPL-3.0-or-later
// Twice the resolution, and where two simulations of one hand part.
#include <doctest/doctest.h>

#include <cmath>

#include "trial/accuracy_measure.hpp"
#include "trial/accuracy_notes.hpp"
#include "trial/course_errors.hpp"
#include "trial/differing_grip.hpp"
#include "trial/told_errors.hpp"

using namespace rhexis;

namespace {

const ObservationSchema told_schema{{"forceps.holding", "bool", ""},
                                    {"rhexis.torn_mm", "mm", ""},
                                    {"fragments.count", "1", ""},
                                    {"phaco.occlusion", "1", ""},
                                    {"phaco.force_mN", "mN", ""}};

/// The time at which both part when from time_s on one value differs, until another time.
std::optional<GripDifference> parted(std::size_t measure, double value, double from_s, double until_s) {
    const std::vector<double> start{0.0, 1.0, 1.0, 0.0, 0.0};
    DifferingGrip grips(told_schema, start, start);
    for (int i = 1; i <= 200; ++i) {
        const double time_s = 0.01 * i;
        std::vector<double> other = start;
        if (time_s >= from_s - 1e-9 && time_s < until_s) {
            other[measure] = value;
        }
        if (const std::optional<GripDifference> found = grips.look(time_s, start, other)) {
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace

TEST_SUITE("measured accuracy") {
    TEST_CASE("a grip, tear, crack or shut mouth that lasts in one of two is where they part") {
        for (const auto& seen : {std::pair<std::size_t, double>(0, 1.0), {1, 1.2}, {2, 2.0}, {3, 0.97}}) {
            const auto measure = seen.first;
            const double value = seen.second;
            CAPTURE(measure);
            const std::optional<GripDifference> found = parted(measure, value, 0.5, 9.0);
            REQUIRE(found.has_value());
            CHECK(found->time_s == doctest::Approx(0.5));
            CHECK(found->measure == told_schema[measure].name);
            CHECK(found->second == value);
        }
    }

    TEST_CASE("what differs for a moment, or by its amount alone, is the same") {
        CHECK_FALSE(parted(0, 1.0, 0.5, 0.58).has_value());
        CHECK_FALSE(parted(3, 0.9, 0.5, 9.0).has_value());
        CHECK_FALSE(parted(4, 40.0, 0.5, 9.0).has_value());
    }

    TEST_CASE("errors: forces in means over a tenth of a second, a path in mm, ends as shares") {
        const ObservationSchema schema{{"phaco.force_mN", "mN", ""},
                                       {"rhexis.tip_x_mm", "mm", ""},
                                       {"rhexis.tip_y_mm", "mm", ""},
                                       {"lens.removed_mm3", "mm^3", ""},
                                       {"chamber.depth_mm", "mm", ""}};
        CourseErrors course(schema);
        CHECK(course.errors().empty());
        for (int i = 1; i <= 100; ++i) {
            const double time_s = 0.01 * i - 1e-4;
            const double chatter = i % 2 == 0 ? 3.0 : 1.0;  // of mean 2
            const double none = std::nan("");
            course.add(time_s, {2.0, i > 50 ? 1.3 : none, 0.4, 0.9 * i, 3.3}, {chatter, 1.0, 0.0, 1.0 * i, 3.0});
        }
        const std::map<std::string, double> errors = course.errors();
        CHECK(errors.at("force") < 0.06);  // the last step of a while may be odd
        CHECK(errors.at("path") == doctest::Approx(std::sqrt((0.3 * 0.3 * 50 + 0.4 * 0.4 * 100) / 75.0)));
        CHECK(errors.at("volume") == doctest::Approx(0.1));
        CHECK(errors.at("depth") == doctest::Approx(0.1));
        CHECK_FALSE(errors.contains("pressure"));
    }

    TEST_CASE("what an implant's steps tell of themselves: the largest overlap and residual; without one nothing") {
        Result<Session> made = Session::create(SceneDescription{}, 1);
        REQUIRE(made.ok());
        ToldErrors told;
        StepOutcome outcome;
        CHECK(told.stepped({made.value(), {}, {}, outcome}).ok());
        CHECK(told.largest().empty());
        for (const auto& [deepest, residual] : {std::pair{0.01, 2e-4}, {0.04, 1e-4}, {0.02, 5e-5}}) {
            ShellStepReport report;
            report.deepest = deepest;
            report.residual = residual;
            outcome.shells = {report};
            CHECK(told.stepped({made.value(), {}, {}, outcome}).ok());
        }
        CHECK(told.largest() == std::map<std::string, double>{{"balance", 2e-4}, {"overlap", 0.04}});
    }

    TEST_CASE("twice the resolution halves edges and step, as far as they may be") {
        SceneDescription scene;
        scene.tissues = {"lens", "anterior_capsule"};
        scene.step_s = 0.01;
        ModelAccuracy lens;
        lens.mesh = {{"patient.tetrahedra", 1000.0}};
        ModelAccuracy capsule;
        capsule.mesh = {{"capsule.triangles", 1500.0}};
        scene.accuracy.models = {lens, capsule};
        const SceneDescription finer = at_twice_the_resolution(scene);
        CHECK(finer.step_s == 0.005);
        CHECK(finer.patient.tetrahedra == 8000);
        CHECK(finer.settings.at("capsule.triangles") == 6000.0);
        scene.accuracy.models[0].mesh["patient.tetrahedra"] = 6000.0;
        scene.accuracy.models[1].mesh["capsule.triangles"] = 6000.0;
        scene.step_s = 0.0015;
        const SceneDescription most = at_twice_the_resolution(scene);
        CHECK(most.patient.tetrahedra == 24000);
        CHECK(most.settings.at("capsule.triangles") == 20000.0);
        CHECK(most.step_s == 0.001);
    }

    TEST_CASE("what was measured is one line") {
        CHECK(measured_line({{"errors", {{"force", 0.5}, {"volume", 0.1}}},
                             {"compared_s", 3.0},
                             {"of_s", 8.0},
                             {"differs", {{"time_s", 3.01}, {"measure", "phaco.occlusion"}}}}) ==
              "against twice the resolution, 3.0 of 8.0 s compared: force 0.5, volume 0.1; from 3.01 s on "
              "phaco.occlusion differs");
    }
}
