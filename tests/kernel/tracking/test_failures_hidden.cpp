// SPDX-License-Identifier: GPL-3.0-or-later
// What is hidden, wholly or partly, and images that merge: each failure is met, and where there is none nothing is
// said.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/rng.hpp"
#include "failure_support.hpp"
#include "support/sanitized.hpp"
#include "synthetic_support.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

/// What a tracker makes of the spot nearest to a sphere's image; sigma 0: it is refused.
struct Believed {
    double sigma_px = 0.0;
    double off_px = 0.0;
};
Believed believed(const synthetic::TrueCamera& camera, const synthetic::Sphere& sphere,
                  const std::vector<Spot>& spots) {
    const Lens lens{camera.lens.fx, camera.lens.fy, camera.lens.cx, camera.lens.cy, 0, 0, 0, 0, 0};
    const Vec2 wanted = sphere_image(lens, sphere.centre, sphere.radius);
    const auto nearest = std::min_element(spots.begin(), spots.end(), [&wanted](const Spot& a, const Spot& b) {
        return (a.at - wanted).norm() < (b.at - wanted).norm();
    });
    if (nearest == spots.end()) {
        return {};
    }
    return {believed_sigma(*nearest, sphere_area(lens, sphere.centre, sphere.radius), 0.0, TrackerSettings{}),
            (nearest->at - wanted).norm()};
}

class Lookout {
public:
    const std::vector<Spot>& look(const synthetic::Scene& scene, std::uint64_t seed) {
        render(camera, pattern_, {&scene, 1}, seed, scratch_, image_);
        return finder_.find(image_.view()).spots;
    }
    synthetic::TrueCamera camera = synthetic::plain_camera();

private:
    synthetic::SensorPattern pattern_{camera, 7};
    synthetic::RenderScratch scratch_{};
    synthetic::Image image_{};
    SpotFinder finder_{SpotSettings{}};
};

/// Before a sphere at 450 mm, so that its straight rim passes `beside_mm` from the sphere's middle.
synthetic::Disc mask(const Vec3& sphere, double angle, double beside_mm) {
    constexpr double radius = 60.0;
    const double share = 430.0 / sphere.z();
    const Vec3 aside(std::cos(angle), std::sin(angle), 0.0);
    synthetic::Disc disc;
    disc.centre = share * sphere + (radius + beside_mm * share) * aside;
    disc.radius = radius;
    disc.soft = 0.2;
    return disc;
}

}  // namespace

TEST_CASE(
    "a sphere of which a mask hides a part is refused, or found where it is; without a mask it is never refused") {
    Lookout lookout;
    Rng rng(11, "masks");
    const int count = rhexis::testing::sanitized ? 20 : 120;
    int refused = 0;
    int helped = 0;
    double worst_px = 0.0;
    double worst_bare_px = 0.0;
    for (int i = 0; i < count; ++i) {
        synthetic::Scene scene =
            synthetic::one_sphere({6.0 * rng.uniform() - 3.0, 6.0 * rng.uniform() - 3.0, 440.0 + 20.0 * rng.uniform()});
        scene.spheres[0].lobe = 0.5;
        const auto seed = static_cast<std::uint64_t>(i);
        const Believed bare = believed(lookout.camera, scene.spheres[0], lookout.look(scene, seed));
        CHECK(bare.sigma_px > 0.0);
        worst_bare_px = std::max(worst_bare_px, bare.off_px);
        const double beside = 2.6 * rng.uniform() - 0.2;
        scene.discs = {mask(scene.spheres[0].centre, 2.0 * std::numbers::pi * rng.uniform(), beside)};
        const Believed hidden = believed(lookout.camera, scene.spheres[0], lookout.look(scene, seed));
        if (hidden.sigma_px > 0.0) {
            worst_px = std::max(worst_px, hidden.off_px);
            ++helped;
        } else {
            ++refused;
        }
    }
    MESSAGE("without mask, farthest off: ", worst_bare_px, " px; with: ", worst_px, " px of ", helped, ", ", refused,
            " refused");
    CHECK(worst_bare_px < 0.06);
    CHECK(worst_px < 0.35);
    CHECK(refused > count / 10);
    CHECK(helped > count / 10);
}

TEST_CASE("two spheres whose images merge are refused as one; a little farther apart both are believed") {
    Lookout lookout;
    for (const double apart_mm : {3.0, 4.5, 5.5, 9.0}) {
        synthetic::Scene scene = synthetic::one_sphere({-0.5 * apart_mm, 0.4, 450.0});
        scene.spheres[0].lobe = 0.5;
        scene.spheres.push_back(scene.spheres[0]);
        scene.spheres[1].centre = {0.5 * apart_mm, -0.4, 460.0};
        const std::vector<Spot>& spots = lookout.look(scene, 1);
        const bool merged = apart_mm < 6.0;
        CHECK(spots.size() == (merged ? 1U : 2U));
        for (const synthetic::Sphere& sphere : scene.spheres) {
            const Believed one = believed(lookout.camera, sphere, spots);
            CHECK_MESSAGE(((one.sigma_px > 0.0 && one.off_px < 0.2) || (merged && one.sigma_px <= 0.0)), "apart ",
                          apart_mm, ", off ", one.off_px);
            CHECK((merged || one.sigma_px > 0.0));
        }
    }
}

TEST_CASE("tools that cross before a camera keep their names and places; so do tools that do not cross") {
    for (const char* name : {"crossing", "circle"}) {
        const ClipRun run = run_of(clip_named(name), marker_plan(rhexis::testing::sanitized ? 1.0 : 1.5));
        const Worst worst = worst_of(run);
        MESSAGE(std::string(name), ": 95 % ", 1e3 * worst.of_95_mm, " um, farthest ", 1e3 * worst.worst_mm, " um");
        CHECK(run.wrong == 0);
        CHECK(worst.missing == 0);
        CHECK(worst.worst_mm < 0.5);
    }
}

TEST_CASE("with any four of six cameras blocked, then any one marker hidden, every pose is there" *
          doctest::skip(rhexis::testing::sanitized)) {
    const ClipRun run = run_of(clip_named("occlusion"), marker_plan(1e9));
    const Worst worst = worst_of(run);
    std::int64_t by_two = 0;
    for (const TipSample& sample : run.traces[1]) {
        by_two += sample.cameras == 2 ? 1 : 0;
    }
    MESSAGE("95 % ", 1e3 * worst.of_95_mm, " um, farthest ", 1e3 * worst.worst_mm, " um; by two cameras ", by_two);
    CHECK(by_two > 200);
    CHECK(run.wrong == 0);
    CHECK(worst.missing == 0);
    CHECK(worst.of_95_mm < 0.1);
    CHECK(worst.worst_mm < 0.4);
}

TEST_CASE("with every camera blocked bodies are held, then lost, never told as seen, and found again at once") {
    synthetic::Clip clip = clip_named("still");
    const ClipRun before = run_of(clip, marker_plan(1.0));
    CHECK(worst_of(before).missing == 0);
    for (int camera = 0; camera < 6; ++camera) {
        clip.covers.push_back({camera, -1, -1, 0.3, 0.7});
    }
    const ClipRun run = run_of(clip, marker_plan(1.0));
    for (const TipTrace& trace : run.traces) {
        for (const TipSample& sample : trace) {
            if (sample.time_s > 0.34 && sample.time_s < 0.66) {
                CHECK_FALSE(sample.seen);
            }
            if (sample.time_s > 0.7 + 2.0 / 120.0) {
                CHECK(sample.seen);
            }
        }
    }
}

}  // namespace rhexis::tracking
