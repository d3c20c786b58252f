// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "math/random_vectors.hpp"
#include "small_rig.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

constexpr double frame_s = 1.0 / 120.0;

/// An instrument that moves about, and a head that does not.
std::vector<Pose> poses_at(double time_s) {
    return {pose_of({20.0 * std::sin(3.0 * time_s), 10.0 * std::cos(2.0 * time_s), 60.0 + 5.0 * time_s},
                    {0.2 * std::sin(time_s), 0.1, 0.3 * time_s}),
            pose_of({-80, 60, 10}, {0.1, 0, 0.4})};
}

/// One of the first 40 marks, and so on.
struct Run {
    Rig rig = small_rig();
    std::vector<MarkerBody> bodies = small_bodies();
    Tracker tracker;
    Rng rng;
    int frame = 0;

    explicit Run(std::optional<int> head = 1, std::uint64_t seed = 1)
        : tracker(rig, bodies, head, TrackerSettings{}), rng(seed) {}

    [[nodiscard]] double time_s() const { return frame_s * frame; }
    std::vector<CameraSpots> spots() { return spots_of(rig, bodies, poses_at(time_s()), time_s(), 0.02, rng); }
    const TrackedBodies& step(const std::vector<CameraSpots>& spots) {
        ++frame;
        return tracker.step(spots);
    }
    const TrackedBodies& step() { return step(spots()); }
    /// How far the instrument's tip is told from where it is, both relative to the head.
    [[nodiscard]] double tip_off_mm(const TrackedBodies& told, int of_frame) const {
        const std::vector<Pose> poses = poses_at(frame_s * of_frame);
        const Vec3 tip = poses[1].to_body(poses[0].to_world(bodies[0].tip.position));
        return (told.bodies[0].tip.position - tip).norm();
    }
};

void drop(std::vector<CameraSpots>& exposures, int marker) {
    for (CameraSpots& exposure : exposures) {
        exposure.spots.erase(exposure.spots.begin() + marker);
    }
}

}  // namespace

TEST_CASE("bodies are found in the first exposure and followed") {
    Run run;
    double worst = 0.0;
    for (int i = 0; i < 240; ++i) {
        const TrackedBodies& told = run.step();
        REQUIRE(told.bodies[0].seen == Seen::seen);
        REQUIRE(told.bodies[1].seen == Seen::seen);
        worst = std::max(worst, run.tip_off_mm(told, i));
        CHECK(told.bodies[0].cameras == 6);
        CHECK(told.bodies[0].markers == 4);
    }
    MESSAGE("tip, farthest off: ", 1000.0 * worst, " um");
    CHECK(worst < 0.1);
}

TEST_CASE("with any four of six cameras blocked and any one marker hidden, every pose is there") {
    double worst = 0.0;
    for (int a = 0; a < 6; ++a) {
        for (int b = a + 1; b < 6; ++b) {
            Run run;
            for (int i = 0; i < 5; ++i) {
                run.step();
            }
            for (int i = 5; i < 12; ++i) {
                std::vector<CameraSpots> two;
                for (const CameraSpots& exposure : run.spots()) {
                    if (exposure.camera == a || exposure.camera == b) {
                        two.push_back(exposure);
                    }
                }
                drop(two, i % 4);
                const TrackedBodies& told = run.step(two);
                REQUIRE(told.bodies[0].seen == Seen::seen);
                CHECK(told.bodies[0].cameras == 2);
                worst = std::max(worst, run.tip_off_mm(told, i));
            }
        }
    }
    MESSAGE("tip, farthest off: ", 1000.0 * worst, " um");
    CHECK(worst < 0.4);
}

TEST_CASE("a body that is not seen is held, then lost, and found again in the first exposure that shows it") {
    Run run;
    for (int i = 0; i < 30; ++i) {
        run.step();
    }
    for (int i = 0; i < 24; ++i) {  // 0.2 s
        std::vector<CameraSpots> without = run.spots();
        for (int m = 0; m < 4; ++m) {
            drop(without, 0);
        }
        const TrackedBodies& told = run.step(without);
        CHECK(told.bodies[0].seen == (frame_s * (i + 1) <= 0.1 ? Seen::held : Seen::lost));
        CHECK(told.bodies[1].seen == Seen::seen);
        if (i < 3) {
            CHECK(run.tip_off_mm(told, 30 + i) < 0.5);
        }
    }
    const TrackedBodies& told = run.step();
    CHECK(told.bodies[0].seen == Seen::seen);
    CHECK(run.tip_off_mm(told, run.frame - 1) < 0.1);
}

TEST_CASE("without the head nothing is told of the others, though they are seen") {
    Run run;
    run.step();
    for (int i = 0; i < 30; ++i) {
        std::vector<CameraSpots> without = run.spots();
        for (int m = 0; m < 4; ++m) {
            drop(without, 4);
        }
        run.step(without);
    }
    std::vector<CameraSpots> without = run.spots();
    for (int m = 0; m < 4; ++m) {
        drop(without, 4);
    }
    CHECK(run.step(without).bodies[0].seen == Seen::lost);
    CHECK(run.step().bodies[0].seen == Seen::seen);
}

TEST_CASE("a spot that is half hidden, by its size or its shape, is not believed") {
    for (const bool by_size : {true, false}) {
        Run run;
        for (int i = 0; i < 10; ++i) {
            run.step();
        }
        double worst = 0.0;
        for (int i = 10; i < 20; ++i) {
            std::vector<CameraSpots> spots = run.spots();
            for (std::size_t c = 0; c < 3; ++c) {  // in half of the cameras
                Spot& spot = spots[c].spots[1];
                spot.at += Vec2(1.5, 0.0);
                (by_size ? spot.area : spot.roundness) *= 0.7;
            }
            worst = std::max(worst, run.tip_off_mm(run.step(spots), i));
        }
        CHECK(worst < 0.1);
    }
}

TEST_CASE("glints, fixed and moving, make no body and disturb none") {
    Run run;
    for (int i = 0; i < 120; ++i) {
        std::vector<CameraSpots> spots = run.spots();
        for (CameraSpots& exposure : spots) {
            for (int k = 0; k < 6; ++k) {
                Spot glint;
                glint.at = k < 3 ? Vec2(200.0 + 150.0 * k + 30.0 * exposure.camera, 300.0)
                                 : Vec2(uniform2(run.rng).cwiseProduct(Vec2(1280.0, 1024.0)));
                glint.area = 250.0;
                exposure.spots.insert(exposure.spots.begin() + k, glint);
            }
        }
        const TrackedBodies& told = run.step(spots);
        REQUIRE(told.bodies[0].seen == Seen::seen);
        CHECK(run.tip_off_mm(told, i) < 0.15);
    }
}

TEST_CASE("a jump is a loss and a find, in one exposure") {
    Run run(std::nullopt);
    for (int i = 0; i < 10; ++i) {
        run.step();
    }
    std::vector<Pose> poses = poses_at(run.time_s());
    poses[0].position += Vec3(40, -30, 20);
    const TrackedBodies& told = run.step(spots_of(run.rig, run.bodies, poses, run.time_s(), 0.02, run.rng));
    CHECK(told.bodies[0].seen == Seen::seen);
    CHECK((told.bodies[0].pose.position - poses[0].position).norm() < 0.1);
}

TEST_CASE("exposures that come late, twice or with their clock set back change nothing") {
    Run run;
    for (int i = 0; i < 10; ++i) {
        run.step();
    }
    const std::vector<CameraSpots> old = spots_of(run.rig, run.bodies, poses_at(0.0), 0.0, 0.02, run.rng);
    const Pose before = run.tracker.step({}).bodies[0].pose;
    const TrackedBodies& told = run.tracker.step(old);
    CHECK(told.bodies[0].pose.position == before.position);
    CHECK(told.time_s == doctest::Approx(frame_s * 9));
    CHECK(run.step().bodies[0].seen == Seen::seen);
}

TEST_CASE("cameras that are out of step by milliseconds are taken at their own times") {
    Run run;
    double worst = 0.0;
    for (int i = 0; i < 60; ++i) {
        std::vector<CameraSpots> mixed;
        for (int c = 0; c < 6; ++c) {
            const double time_s = run.time_s() + 0.0008 * (c - 2);
            mixed.push_back(
                spots_of(run.rig, run.bodies, poses_at(time_s), time_s, 0.02, run.rng)[static_cast<std::size_t>(c)]);
        }
        const TrackedBodies& told = run.step(mixed);
        REQUIRE(told.bodies[0].seen == Seen::seen);
        if (i > 10) {  // its motion is known
            const std::vector<Pose> poses = poses_at(told.time_s);
            const Vec3 tip = poses[1].to_body(poses[0].to_world(run.bodies[0].tip.position));
            worst = std::max(worst, (told.bodies[0].tip.position - tip).norm());
        }
    }
    MESSAGE("tip, farthest off: ", 1000.0 * worst, " um");
    CHECK(worst < 0.15);
}

}  // namespace rhexis::tracking
