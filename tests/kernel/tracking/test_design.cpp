// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "tracking/bodies/design.hpp"
#include "tracking/bodies/identity.hpp"
#include "tracking/bodies/known_bodies.hpp"

namespace rhexis::tracking {
namespace {

/// A handle that leaves the tip to the side, as bent instruments' do.
DesignPlan bent_plan() {
    const std::array<RoundedCone, 2> cones{{{Vec3::Zero(), {0, 0, 1}, 0.1, 0.2}, {{0, 0, 1}, {0, -110, 12}, 2.0, 4.0}}};
    DesignPlan plan;
    plan.name = "pick";
    plan.handle = handle_of(cones, "pick").value();
    plan.moves = 8000;
    return plan;
}

std::vector<MarkerBody> some_bodies() {
    const std::array<std::string, 2> names{"phaco", "chopper"};
    return known_bodies(names).value();
}

}  // namespace

TEST_CASE("a body is designed that is known from others and that a mount has room for, the same for the same seed") {
    const DesignPlan plan = bent_plan();
    const Result<MarkerBody> body = design_body(plan, {some_bodies(), {}});
    REQUIRE_MESSAGE(body.ok(), (body ? "" : body.error().text()));
    CHECK(body.value().markers == design_body(plan, {some_bodies(), {}}).value().markers);
    std::vector<MarkerBody> all = some_bodies();
    all.push_back(body.value());
    CHECK(check_signatures(all).ok());
    const Handle handle = moved_to(body.value().tip, plan.handle);
    CHECK(mount_of(body.value(), handle).ok());
    CHECK(handle.along.z() == doctest::Approx(1.0));
    CHECK(handle.at(95.0).norm() < 1e-9);
    CHECK((body.value().tip.to_world(plan.handle.at(95.0))).norm() < 1e-9);
    DesignPlan other = plan;
    other.seed = 2;
    CHECK(design_body(other, {some_bodies(), {}}).value().markers != body.value().markers);
}

TEST_CASE("beside others no distance is theirs") {
    const std::vector<MarkerBody> beside = some_bodies();
    const Result<MarkerBody> body = design_body(bent_plan(), {{}, beside});
    REQUIRE_MESSAGE(body.ok(), (body ? "" : body.error().text()));
    const auto each = [](const MarkerBody& of, const auto& look) {
        for (std::size_t i = 0; i < of.markers.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                look((of.markers[i] - of.markers[j]).norm());
            }
        }
    };
    double least = 1e9;
    for (const MarkerBody& other : beside) {
        each(other, [&](double one) {
            each(body.value(), [&](double its) { least = std::min(least, std::abs(one - its)); });
        });
    }
    CHECK(least > 2.0);
}

TEST_CASE("a design that cannot be is refused with what is in the way") {
    DesignPlan plan = bent_plan();
    plan.apart_mm = 5.0;
    plan.reach_mm = 18.0;
    const Result<MarkerBody> none = design_body(plan, {{}, some_bodies()});
    REQUIRE_FALSE(none.ok());
    CHECK(none.error().text().find("pick") != std::string::npos);
    plan.reach_mm = 5.0;
    CHECK(design_body(plan, {}).error().text().find("reach_mm is 5") != std::string::npos);
    CHECK_FALSE(handle_of({}, "nothing").ok());
}

TEST_CASE("the error of a tip is what errors of its spheres make of it") {
    const MarkerBody body = some_bodies()[1];
    Rng rng(5);
    double squares = 0.0;
    constexpr int count = 4000;
    constexpr double sigma = 0.01;
    for (int i = 0; i < count; ++i) {
        std::vector<Vec3> points = body.markers;
        for (Vec3& point : points) {
            point += sigma / std::sqrt(3.0) * normal3(rng);
        }
        squares += (fitted(body.markers, points).to_world(body.tip.position) - body.tip.position).squaredNorm();
    }
    CHECK(std::sqrt(squares / count) / sigma == doctest::Approx(tip_error_share(body)).epsilon(0.05));
}

}  // namespace rhexis::tracking
