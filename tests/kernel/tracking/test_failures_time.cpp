// SPDX-License-Identifier: GPL-3.0-or-later
// What moves fast, a camera that is knocked, a head that moves, and exposures that do not come as they should.
#include <doctest/doctest.h>

#include "failure_support.hpp"
#include "small_rig.hpp"
#include "support/sanitized.hpp"
#include "tracking/camera_health.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

/// When a camera was first named after `from_s`; none: never.
struct Named {
    std::optional<double> at_s{};
    int camera = -1;
    bool early = false;  ///< it was named before
};
Named watch(const synthetic::Clip& clip, double from_s, double until_s) {
    const std::vector<std::vector<CameraSpots>> recorded =
        record_spots(workplace().rig, clip, marker_plan(until_s)).value();
    Tracker tracker(workplace().solver, workplace().bodies, 0, TrackerSettings{});
    CameraHealth health(6);
    Named named;
    for (const std::vector<CameraSpots>& exposures : recorded) {
        const double time_s = tracker.step(exposures).time_s;
        health.add(time_s, tracker.offsets());
        const std::optional<Drift> drift = health.drift();
        if (drift && time_s < from_s) {
            named.early = true;
        } else if (drift && !named.at_s) {
            named.at_s = time_s;
            named.camera = drift->camera;
        }
    }
    return named;
}

/// Farthest that an instrument's tip is told from where it is relative to a head that stays, or goes at 20 mm/s from
/// 0.5 s on; and its scatter while all rests.
struct HeadRun {
    double worst_mm = 0.0;
    double scatter_mm = 0.0;
};
HeadRun follow_head(double average_s, double speed_mm_s) {
    const Rig rig = small_rig();
    const std::vector<MarkerBody> bodies = small_bodies();
    TrackerSettings settings;
    settings.head.average_s = average_s;
    Tracker tracker(rig, bodies, 1, settings);
    Rng rng(2);
    HeadRun result;
    double squares = 0.0;
    constexpr int frames = 180;
    for (int i = 0; i < frames; ++i) {
        const double time_s = i / 120.0;
        const double gone_mm = speed_mm_s * std::max(0.0, time_s - 0.5);
        const std::vector<Pose> poses{pose_of({0, 0, 60}, {0.1, 0.2, 0}),
                                      pose_of({-80 + gone_mm, 60, 10}, {0.1, 0, 0.4})};
        const TrackedBodies& told = tracker.step(spots_of(rig, bodies, poses, time_s, 0.03, rng));
        const Vec3 tip = poses[1].to_body(poses[0].to_world(bodies[0].tip.position));
        const double off = (told.bodies[0].tip.position - tip).norm();
        if (i >= 30) {
            result.worst_mm = std::max(result.worst_mm, off);
            squares += off * off / (frames - 30);
        }
    }
    result.scatter_mm = std::sqrt(squares);
    return result;
}

}  // namespace

TEST_CASE("a tool at half a metre a second is followed without a gap, as one that rests is") {
    for (const char* name : {"insertions", "still"}) {
        const ClipRun run = run_of(clip_named(name), marker_plan(rhexis::testing::sanitized ? 0.4 : 0.8));
        const Worst worst = worst_of(run);
        MESSAGE(std::string(name), ": 95 % ", 1e3 * worst.of_95_mm, " um, farthest ", 1e3 * worst.worst_mm, " um");
        CHECK(worst.missing == 0);
        CHECK(run.wrong == 0);
        CHECK(worst.of_95_mm < 0.15);
    }
}

TEST_CASE("a camera that is knocked by a tenth of a degree is named within a second, and none is before or without") {
    synthetic::Clip clip = clip_named("bump");
    clip.bump.time_s = 1.0;
    const Named bumped = watch(clip, 1.0, 2.0);
    CHECK_FALSE(bumped.early);
    REQUIRE(bumped.at_s.has_value());
    MESSAGE("named after ", *bumped.at_s - 1.0, " s");
    CHECK(bumped.camera == clip.bump.camera);
    const Named still = watch(clip_named("circle"), 0.0, 2.0);
    CHECK_FALSE(still.at_s.has_value());
}

TEST_CASE("exposures that are lost, late, out of order and 5 ms apart cost little; none goes back in time") {
    const synthetic::Clip clip = clip_named("tremor");
    const double longest_s = rhexis::testing::sanitized ? 0.5 : 3.0;
    const Worst bare = worst_of(run_of(clip, marker_plan(longest_s)));
    CHECK(bare.missing == 0);
    ClipPlan plan = marker_plan(longest_s);
    plan.delivery.skew_s = 5e-3;
    plan.delivery.lost = 0.1;
    plan.delivery.late = 0.1;
    plan.delivery.jitter_s = 2e-3;
    const ClipRun run = run_of(clip, plan);
    const Worst worst = worst_of(run);
    MESSAGE("95 % ", 1e3 * worst.of_95_mm, " um, as they should be ", 1e3 * bare.of_95_mm, " um; missing ",
            worst.missing);
    CHECK(worst.missing < 3 * static_cast<std::int64_t>(run.traces[1].size()) / 50);
    CHECK(worst.of_95_mm < 0.1);
    CHECK(run.wrong == 0);
    for (std::size_t i = 1; i < run.traces[0].size(); ++i) {
        CHECK(run.traces[0][i].time_s >= run.traces[0][i - 1].time_s);
    }
}

TEST_CASE("a head that rests is averaged, one that moves is followed at once") {
    const HeadRun averaged = follow_head(0.5, 0.0);
    const HeadRun each = follow_head(0.0, 0.0);
    const HeadRun moving = follow_head(0.5, 20.0);
    const HeadRun moving_each = follow_head(0.0, 20.0);
    MESSAGE("resting: ", 1e3 * averaged.scatter_mm, " um, without the average ", 1e3 * each.scatter_mm,
            " um; moving, farthest: ", 1e3 * moving.worst_mm, " and ", 1e3 * moving_each.worst_mm, " um");
    CHECK(averaged.scatter_mm < 0.9 * each.scatter_mm);
    CHECK(moving.worst_mm < moving_each.worst_mm + 0.05);
}

}  // namespace rhexis::tracking
