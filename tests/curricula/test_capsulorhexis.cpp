// SPDX-License-Identifier: GPL-3.0-or-later
// The capsulorhexis: what the eye's place in the field earns (OSACSS G2).
#include <doctest/doctest.h>

#include "attempt.hpp"
#include "support/sample.hpp"

using namespace rhexis;
using rhexis::test::Attempt;
using rhexis::test::sample_at;

namespace {

/// G2 of an attempt that moves a needle to and fro over the lens for two seconds, the microscope sent there before.
double score_at(const Vec3& from_pupil) {
    Attempt attempt("none", 1, {{"capsule.triangles", "300"}, {"step_s", "0.01"}}, "capsulorhexis");
    const DeviceSample foot = sample_at(3, Vec3(0.0, 0.0, attempt.session().eye().anatomy.iris_z) + from_pupil);
    for (int i = 0; i < 300; ++i) {
        attempt.step({foot});
    }
    for (int i = 0; i < 200; ++i) {
        const double aside = 0.01 * static_cast<double>(i % 100 < 50 ? i % 50 : 50 - i % 50);
        attempt.step({sample_at(0, Vec3(aside, -1.0, 2.8)), foot});
    }
    const nlohmann::json result = attempt.result();
    for (const nlohmann::json& item : result.at("osacss").at("items")) {
        if (item.at("id") == "G2") {
            return item.at("score").get<double>();
        }
    }
    FAIL("G2 is not scored");
    return 0.0;
}

}  // namespace

TEST_CASE("an eye in the middle and in focus earns five points for its place, at the edge or blurred fewer") {
    CHECK(score_at(Vec3::Zero()) == doctest::Approx(5.0));
    CHECK(score_at(Vec3(0.0, 0.0, 0.6)) == doctest::Approx(5.0));         // within the depth of field
    CHECK(score_at(Vec3(0.0, 0.0, 3.0)) == doctest::Approx(3.72));        // never in focus
    CHECK(score_at(Vec3(0.3 * 7.3, 0.0, 0.0)) == doctest::Approx(4.43));  // offset three points, still all in view
    CHECK(score_at(Vec3(4.5, 0.0, 0.0)) == doctest::Approx(2.71));        // offset and view one point each
}
