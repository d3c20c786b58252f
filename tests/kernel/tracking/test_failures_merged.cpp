// SPDX-License-Identifier: GPL-3.0-or-later
// Images in which spheres of two instruments merge, for some cameras.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "failure_support.hpp"
#include "support/sanitized.hpp"
#include "tracking/measure/spot_errors.hpp"
#include "tracking/synthetic/marker_spots.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

constexpr double passes_hz = 3.0;
constexpr double across_mm = 5.0;

/// Two instruments that pass each other before the first camera at up to 94 mm/s, from one side of each other to the
/// other; where they do not cross, beside each other.
synthetic::Clip passing(bool crossing) {
    synthetic::Clip clip = clip_named("crossing");
    const Vec3 sight = clip.eyes[0].normalized();
    // a way on which two pairs of spheres pass before each other at once
    const Vec3 across = Eigen::AngleAxisd(0.375 * std::numbers::pi, sight) * sight.unitOrthogonal();
    for (const int body : {1, 2}) {
        const double side = body == 1 ? 1.0 : -1.0;
        synthetic::Motion& motion = clip.motions[static_cast<std::size_t>(body)];
        motion.moves = {{side * across_mm * across, passes_hz, -0.5 * std::numbers::pi}};
        motion.tip.position += side * (crossing ? -7.0 : 45.0) * across;
    }
    return clip;
}

/// Pairs of spheres of the two that one camera has less than their radii apart, in an exposure.
int merged_pairs(const synthetic::Clip& clip, int camera, double time_s) {
    synthetic::Scene scene;
    synthetic::Scene seen;
    scene_at(clip, time_s, scene);
    const synthetic::TrueCamera it = camera_at(clip, workplace().rig, camera, time_s);
    seen_from(it.pose, scene, seen);
    const auto image = [&](std::size_t sphere) {
        return distorted(it.lens, synthetic::outline(seen.spheres[sphere]).centre);
    };
    int pairs = 0;
    for (std::size_t one = 4; one < 8; ++one) {
        for (std::size_t other = 8; other < 12; ++other) {
            const double radii = it.lens.fx * (seen.spheres[one].radius / seen.spheres[one].centre.z() +
                                               seen.spheres[other].radius / seen.spheres[other].centre.z());
            pairs += (image(one) - image(other)).norm() < radii ? 1 : 0;
        }
    }
    return pairs;
}

struct Passed {
    int merged = 0;         ///< pairs of spheres, of all cameras and exposures
    int views = 0;          ///< cameras that saw some
    double jump_mm = 0.0;   ///< farthest that the error of a tip goes from one exposure to the next
    double worst_mm = 0.0;  ///< farthest that a tip is told off
    int missing = 0;
    int wrong = 0;
};
Passed pass(bool crossing, int frames) {
    const synthetic::Clip clip = passing(crossing);
    ClipPlan plan = marker_plan(frames / 120.0);
    plan.images = true;
    const ClipRun run = run_of(clip, plan);
    Passed passed;
    passed.wrong = run.wrong;
    for (int camera = 0; camera < 6; ++camera) {
        int of_camera = 0;
        for (int frame = 0; frame < frames; ++frame) {
            of_camera += merged_pairs(clip, camera, frame / 120.0);
        }
        passed.merged += of_camera;
        passed.views += of_camera > 0 ? 1 : 0;
    }
    for (const std::size_t body : {std::size_t{1}, std::size_t{2}}) {
        const TipTrace& trace = run.traces[body];
        for (std::size_t i = 1; i < trace.size(); ++i) {
            passed.missing += trace[i].seen ? 0 : 1;
            if (trace[i].seen && trace[i - 1].seen) {
                const Vec3 off = trace[i].told.position - trace[i].is.position;
                const Vec3 before = trace[i - 1].told.position - trace[i - 1].is.position;
                passed.jump_mm = std::max(passed.jump_mm, (off - before).norm());
                passed.worst_mm = std::max(passed.worst_mm, off.norm());
            }
        }
    }
    return passed;
}

}  // namespace

TEST_CASE("two tools whose spheres merge in images of one camera stay valid by the others, and do not jump" *
          doctest::skip(rhexis::testing::sanitized)) {
    const Passed crossing = pass(true, 16);
    const Passed beside = pass(false, 4);
    MESSAGE(crossing.merged, " pairs merged in ", crossing.views, " views; farthest jump ", 1e3 * crossing.jump_mm,
            " um, farthest off ", 1e3 * crossing.worst_mm, " um; beside each other ", beside.merged, " pairs, ",
            1e3 * beside.jump_mm, " um");
    CHECK(crossing.merged > 10);
    CHECK(beside.merged == 0);
    for (const Passed& passed : {crossing, beside}) {
        CHECK(passed.wrong == 0);
        CHECK(passed.missing == 0);
        CHECK(passed.jump_mm < 0.1);
        CHECK(passed.worst_mm < 0.1);
    }
}

}  // namespace rhexis::tracking
