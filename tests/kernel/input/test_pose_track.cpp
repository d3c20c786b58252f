// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "input/pose_track.hpp"

using namespace rhexis;

namespace {

Quat about_z(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

/// Goes 20 mm/s to the right and turns by 1 rad/s.
Pose on_its_way(std::int64_t time_us) {
    const double t = 1e-6 * static_cast<double>(time_us);
    return {Vec3(20.0 * t, 1.0, -2.0), about_z(t)};
}

PoseTrack a_track(std::int64_t from_us, std::int64_t to_us, std::int64_t every_us = 10'000) {
    PoseTrack track;
    for (std::int64_t t = from_us; t <= to_us; t += every_us) {
        track.add(t, on_its_way(t));
    }
    return track;
}

void check_is(const Pose& pose, const Pose& wanted, double within) {
    CHECK((pose.position - wanted.position).norm() < within);
    CHECK(pose.orientation.angularDistance(wanted.orientation) < within);
}

}  // namespace

TEST_SUITE("pose track") {
    TEST_CASE("between two poses it is where an even movement is, to rounding") {
        const PoseTrack track = a_track(0, 500'000);
        for (const std::int64_t t : {0, 1, 3'333, 10'000, 47'001, 499'999, 500'000}) {
            const auto found = track.at(t);
            REQUIRE(found);
            CHECK(found->unseen_us == 0);
            check_is(found->pose, on_its_way(t), 1e-7);  // acos near 1
        }
        CHECK_FALSE(track.at(-1));
        CHECK(track.interval_us() == 10'000);
        // the shorter way round, whatever the sign of a quaternion
        Quat turned = about_z(0.2);
        turned.coeffs() *= -1.0;
        check_is(between({Vec3::Zero(), about_z(0.0)}, {Vec3::UnitX(), turned}, 0.5),
                 {Vec3(0.5, 0.0, 0.0), about_z(0.1)}, 1e-7);
    }

    TEST_CASE("after the last pose it goes on for 30 ms, and no farther") {
        const PoseTrack track = a_track(0, 100'000);
        check_is(track.at(110'000)->pose, on_its_way(110'000), 1e-7);
        check_is(track.at(130'000)->pose, on_its_way(130'000), 1e-7);
        check_is(track.at(131'000)->pose, on_its_way(130'000), 1e-7);
        check_is(track.at(900'000)->pose, on_its_way(130'000), 1e-7);
        CHECK(track.at(900'000)->unseen_us == 800'000);
        PoseTrack single;
        single.add(0, on_its_way(0));
        check_is(single.at(20'000)->pose, on_its_way(0), 1e-12);
    }

    TEST_CASE("stamps that go back are left out") {
        PoseTrack track = a_track(0, 100'000);
        CHECK(track.add(100'000, on_its_way(90'000)) == PoseTrack::Taken::stale);
        CHECK(track.add(95'000, on_its_way(95'000)) == PoseTrack::Taken::stale);
        CHECK(track.add(105'000, on_its_way(105'000)) == PoseTrack::Taken::followed);
        check_is(track.at(98'000)->pose, on_its_way(98'000), 1e-7);
    }

    TEST_CASE("a leap is left out, whatever the stamps say; a fast hand is followed") {
        PoseTrack track = a_track(0, 100'000);
        Pose away = on_its_way(110'000);
        away.position.y() += 6.0;
        CHECK(track.add(110'000, away) == PoseTrack::Taken::jumped);
        CHECK(track.add(200'000, away) == PoseTrack::Taken::jumped);  // no faster for having been unseen
        check_is(track.at(105'000)->pose, on_its_way(105'000), 1e-7);
        CHECK(track.add(220'000, on_its_way(220'000)) == PoseTrack::Taken::followed);
        Pose fast = on_its_way(230'000);
        fast.position.y() += 4.5;
        CHECK(track.add(230'000, fast) == PoseTrack::Taken::followed);
        fast.position.y() += 2.5;
        CHECK(track.add(234'000, fast) == PoseTrack::Taken::jumped);  // 2.5 mm within 4 ms
    }

    TEST_CASE("after a loss a new stretch begins, and nothing is made up between the two") {
        PoseTrack track = a_track(0, 100'000);
        Pose elsewhere = on_its_way(0);
        elsewhere.position.z() += 80.0;
        CHECK(track.add(301'000, elsewhere) == PoseTrack::Taken::began);
        CHECK(track.at(200'000)->unseen_us == 100'000);
        check_is(track.at(300'000)->pose, on_its_way(130'000), 1e-7);
        CHECK(track.at(301'000)->stretch == track.at(300'000)->stretch + 1);
        check_is(track.at(301'000)->pose, elsewhere, 1e-12);
    }

    TEST_CASE("a number is what was told last; of two soon after each other it goes evenly") {
        ValueTrack track;
        CHECK_FALSE(track.at(0, true));
        track.add(100'000, 1.0);
        track.add(120'000, 2.0);
        track.add(900'000, 3.0);
        track.add(800'000, 9.0);  // stamped before the one before
        CHECK(track.at(0, true) == 1.0);
        CHECK(track.at(110'000, true) == doctest::Approx(1.5));
        CHECK(track.at(110'000, false) == 1.0);
        CHECK(track.at(899'999, true) == 2.0);
        CHECK(track.at(5'000'000, true) == 3.0);
        track.forget_times();
        CHECK(track.at(-1'000'000'000, false) == 3.0);
        track.add(50, 4.0);
        CHECK(track.at(49, true) == 3.0);
        CHECK(track.at(50, true) == 4.0);
    }
}
