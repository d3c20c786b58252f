// SPDX-License-Identifier: GPL-3.0-or-later
// Light that is no marker, points that are none, and bodies that are much alike.
#include <doctest/doctest.h>

#include <numbers>

#include "failure_support.hpp"
#include "small_rig.hpp"
#include "support/sanitized.hpp"
#include "tracking/points/matching.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

/// Fixed ones on the drape, and others that go round as a wet instrument's do.
void add_glints(double time_s, synthetic::Scene& scene) {
    for (int i = 0; i < 6; ++i) {
        const double turn = 2.0 * std::numbers::pi * (i / 6.0 + 0.7 * time_s);
        scene.glints.push_back({{70.0 - 25.0 * i, -60.0 + 20.0 * i, 5.0 * i}, 180.0, 3.0});
        scene.glints.push_back({{60.0 * std::cos(turn), 60.0 * std::sin(turn), 40.0 + 8.0 * i}, 200.0, 4.0});
    }
}

synthetic::Stage stage_of(const synthetic::Clip& clip, bool bodies, bool glints) {
    synthetic::Stage stage;
    stage.scene = [&clip, bodies, glints](double time_s, synthetic::Scene& scene) {
        scene_at(clip, time_s, scene);
        if (!bodies) {
            scene.spheres.clear();
        }
        if (glints) {
            add_glints(time_s, scene);
        }
    };
    return stage;
}

ClipRun run_stage(const synthetic::Clip& clip, bool bodies, bool glints, int frames) {
    synthetic::Film film;
    film.frames = frames;
    film.seed = 3;
    const auto source = film_markers(workplace().rig, stage_of(clip, bodies, glints), film);
    REQUIRE(source.ok());
    return track_spots(*source.value(), workplace().solver, clip, marker_plan(1e9)).value();
}

/// For a while an instrument's last marker is hidden and the third lies turned by so much about the line through the
/// other two, as another's point may.
ClipRun run_with_turned_point(double turn_deg, double most_leap_mm) {
    constexpr double from_s = 0.3;
    constexpr double until_s = 0.36;
    const synthetic::Clip clip = clip_named("still");
    const std::size_t first = clip.bodies[0].markers.size();
    REQUIRE(clip.bodies[1].markers.size() == 4);
    synthetic::Stage stage;
    stage.scene = [&clip, first, turn_deg](double time_s, synthetic::Scene& scene) {
        scene_at(clip, time_s, scene);
        if (time_s < from_s || time_s > until_s) {
            return;
        }
        const Vec3 foot = scene.spheres[first].centre;
        const Vec3 axis = (scene.spheres[first + 1].centre - foot).normalized();
        Vec3& third = scene.spheres[first + 2].centre;
        third = foot + Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180.0, axis) * (third - foot);
        scene.spheres.erase(scene.spheres.begin() + static_cast<std::ptrdiff_t>(first + 3));
    };
    synthetic::Film film;
    film.frames = 60;
    film.seed = 3;
    const auto source = film_markers(workplace().rig, stage, film);
    REQUIRE(source.ok());
    ClipPlan plan = marker_plan(1e9);
    plan.tracker.most_leap_mm = most_leap_mm;
    return track_spots(*source.value(), workplace().solver, clip, plan).value();
}

/// Points that no marker is near.
int ghosts(const std::vector<MatchedPoint>& points, const synthetic::Clip& clip, double time_s) {
    constexpr double near_mm = 5.0;  // the solver's frame is some millimetres from the true one
    int count = 0;
    for (const MatchedPoint& point : points) {
        bool real = false;
        for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
            const Pose pose = pose_at(clip, static_cast<int>(i), time_s);
            for (const Vec3& marker : clip.bodies[i].markers) {
                real = real || (pose.to_world(marker) - point.point).norm() < near_mm;
            }
        }
        count += real ? 0 : 1;
    }
    return count;
}

}  // namespace

TEST_CASE("glints, fixed and moving, disturb no body, and alone they make none") {
    synthetic::Clip clip = clip_named("tremor");
    clip.specks = 3.0;
    const int frames = rhexis::testing::sanitized ? 30 : 120;
    const Worst bare = worst_of(run_stage(clip, true, false, frames));
    const ClipRun run = run_stage(clip, true, true, frames);
    const Worst worst = worst_of(run);
    MESSAGE("95 % ", 1e3 * worst.of_95_mm, " um, without glints ", 1e3 * bare.of_95_mm, " um");
    CHECK(worst.missing == 0);
    CHECK(run.wrong == 0);
    CHECK(worst.of_95_mm < bare.of_95_mm + 0.02);
    for (const TipTrace& trace : run_stage(clip, false, true, frames).traces) {
        for (const TipSample& sample : trace) {
            CHECK_FALSE(sample.seen);
        }
    }
}

TEST_CASE("two cameras meet in ghosts, three do not, and no body comes of them") {
    synthetic::Clip clip = clip_named("circle");
    clip.glints = false;  // they are where several cameras see them, and no ghosts
    clip.specks = 0.0;
    const int frames = rhexis::testing::sanitized ? 20 : 200;
    const std::vector<std::vector<CameraSpots>> recorded =
        record_spots(workplace().rig, clip, marker_plan(frames / 120.0)).value();
    int by_two = 0;
    int by_three = 0;
    for (const std::vector<CameraSpots>& exposures : recorded) {
        std::vector<std::vector<bool>> taken;
        for (const CameraSpots& exposure : exposures) {
            taken.emplace_back(exposure.spots.size(), false);
        }
        MatchingSettings settings;
        by_three +=
            ghosts(match_spots(workplace().solver.cameras, exposures, taken, settings), clip, exposures[0].time_s);
        settings.least_views = 2;
        by_two += ghosts(match_spots(workplace().solver.cameras, {exposures.data(), 2}, {taken[0], taken[1]}, settings),
                         clip, exposures[0].time_s);
    }
    MESSAGE("ghosts in ", frames, " exposures: by two cameras ", by_two, ", by three or more ", by_three);
    if (!rhexis::testing::sanitized) {  // of a few exposures there may be none
        CHECK(by_two > 0);
        CHECK(by_three * 20 < by_two);
    }
    const std::vector<std::vector<CameraSpots>> two = only_cameras(recorded, {0, 1}, 0.05);
    RecordedSpots source(two, 120.0);
    const ClipRun run = track_spots(source, workplace().solver, clip, marker_plan(1e9)).value();
    CHECK(run.wrong == 0);
    CHECK(tip_errors(run.traces[1]).valid > 0);
}

TEST_CASE("bodies that could be mistaken are refused; those of the synthetic rig are not") {
    std::vector<MarkerBody> bodies = synthetic::standard_bodies();
    CHECK(check_signatures(bodies).ok());
    MarkerBody twin = bodies[1];
    twin.name = "twin";
    twin.markers[0] += Vec3(0.7, 0.0, 0.0);
    bodies.push_back(twin);
    const Status refused = check_signatures(bodies);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().text().find("twin") != std::string::npos);
}

TEST_CASE("of two bodies whose distances differ by 2 mm the one that is there is told, and never the other") {
    MarkerBody small = small_bodies()[0];
    MarkerBody great = small;
    great.name = "great";
    double least_mm = 1e9;
    for (std::size_t i = 0; i < small.markers.size(); ++i) {
        great.markers[i] = 1.056 * small.markers[i];
        for (std::size_t j = 0; j < i; ++j) {
            least_mm = std::min(least_mm, 0.056 * (small.markers[i] - small.markers[j]).norm());
        }
    }
    CHECK(least_mm > 1.9);
    const Rig rig = small_rig();
    const std::vector<MarkerBody> bodies{small, great};
    const int frames = rhexis::testing::sanitized ? 100 : 2000;
    Rng rng(8);
    for (const std::size_t present : {std::size_t{0}, std::size_t{1}}) {
        int told = 0;
        int mistaken = 0;
        for (int i = 0; i < frames / 2; ++i) {
            Tracker tracker(rig, bodies, std::nullopt, TrackerSettings{});
            const Vec3 turn{rng.normal(), rng.normal(), rng.normal()};
            const Vec3 position{30.0 * rng.normal(), 30.0 * rng.normal(), 30.0 * rng.normal()};
            const Pose pose = pose_of(position, turn);
            const TrackedBodies& now = tracker.step(spots_of(rig, {bodies[present]}, {pose}, 0.01 * i, 0.05, rng));
            told += now.bodies[present].seen == Seen::seen ? 1 : 0;
            mistaken += now.bodies[1 - present].seen == Seen::seen ? 1 : 0;
        }
        CHECK(told > frames / 2 - frames / 50);
        CHECK(mistaken == 0);
    }
}

TEST_CASE("a point on the circle about two markers is not taken for the third; a third marker in its place is") {
    for (const double turn_deg : {4.0, 0.0}) {
        const TipTrace trace = run_with_turned_point(turn_deg, TrackerSettings{}.most_leap_mm).traces[1];
        const ErrorFigures figures = tip_errors(trace);
        CHECK(figures.worst < 1.0);
        // Held, and then seen again as soon as the others are back.
        CHECK((figures.frames - figures.valid > 0) == (turn_deg > 0.0));
        CHECK(figures.frames - figures.valid <= 9);
    }
    CHECK(tip_errors(run_with_turned_point(4.0, 1e9).traces[1]).worst > 4.0);
}

}  // namespace rhexis::tracking
