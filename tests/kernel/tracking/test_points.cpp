// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "math/random_vectors.hpp"
#include "small_rig.hpp"
#include "tracking/points/matching.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

std::vector<View> views_of(const Rig& rig, const Vec3& point) {
    std::vector<View> views;
    for (int i = 0; i < static_cast<int>(rig.cameras.size()); ++i) {
        views.push_back({i, 0, *project(rig.cameras[static_cast<std::size_t>(i)], point)});
    }
    return views;
}

std::vector<std::vector<bool>> none_of(const std::vector<CameraSpots>& exposures) {
    std::vector<std::vector<bool>> none;
    for (const CameraSpots& exposure : exposures) {
        none.emplace_back(exposure.spots.size(), false);
    }
    return none;
}

Vec3 any_place(Rng& rng) { return 80.0 * (2.0 * uniform3(rng) - Vec3::Ones()); }

/// Spots of points, in each camera in another order.
std::vector<CameraSpots> shuffled(const Rig& rig, const std::vector<Vec3>& points, double noise_px, Rng& rng) {
    std::vector<CameraSpots> all;
    for (int c = 0; c < static_cast<int>(rig.cameras.size()); ++c) {
        CameraSpots exposure{c, 0.0, {}};
        for (const Vec3& point : points) {
            Spot spot;
            spot.at = *project(rig.cameras[static_cast<std::size_t>(c)], point) + noise_px * normal2(rng);
            exposure.spots.insert(exposure.spots.begin() + rng.integer(0, static_cast<int>(exposure.spots.size())),
                                  spot);
        }
        all.push_back(exposure);
    }
    return all;
}

}  // namespace

TEST_CASE("a point is where its images say, and noise moves it as much as the rays' angles allow") {
    const Rig rig = small_rig();
    Rng rng(5);
    for (int i = 0; i < 50; ++i) {
        const Vec3 point = any_place(rng);
        std::vector<View> views = views_of(rig, point);
        const std::optional<Triangulated> exact = triangulate(rig.cameras, views);
        REQUIRE(exact.has_value());
        CHECK((exact->point - point).norm() < 1e-6);
        CHECK(exact->residual_px < 1e-6);
        for (View& view : views) {
            view.at += 0.05 * normal2(rng);
        }
        const std::optional<Triangulated> noisy = triangulate(rig.cameras, views);
        CHECK((noisy->point - point).norm() < 0.06);
        views.resize(2);
        CHECK((triangulate(rig.cameras, views)->point - point).norm() < 0.15);
        views.resize(1);
        CHECK_FALSE(triangulate(rig.cameras, views).has_value());
    }
}

TEST_CASE("rays that are parallel give no point") {
    Rig rig = small_rig(2);
    rig.cameras[1] = rig.cameras[0];
    rig.cameras[1].pose.position += Vec3(1.0, 0.0, 0.0);
    CHECK_FALSE(triangulate(rig.cameras, views_of(rig, Vec3::Zero())).has_value());
}

TEST_CASE("spots of sixteen points in six cameras, in any order, are matched to just these points") {
    const Rig rig = small_rig();
    Rng rng(6);
    for (int round = 0; round < 10; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 16; ++i) {
            points.push_back(any_place(rng));
        }
        const std::vector<CameraSpots> exposures = shuffled(rig, points, 0.05, rng);
        const std::vector<MatchedPoint> matched = match_spots(rig.cameras, exposures, none_of(exposures), {});
        int found = 0;
        for (const Vec3& point : points) {
            found += std::any_of(matched.begin(), matched.end(), [&point](const MatchedPoint& one) {
                return (one.point - point).norm() < 0.2 && one.views.size() >= 5;
            });
        }
        CHECK(found == 16);
        CHECK(matched.size() <= 17);  // a ghost of what two points left over, now and then
    }
}

TEST_CASE("two cameras alone give points only where two are enough, and then ghosts as well") {
    const Rig rig = small_rig(2);
    Rng rng(7);
    MatchingSettings two;
    two.least_views = 2;
    int matched_in_all = 0;
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 12; ++i) {
            points.push_back(any_place(rng));
        }
        const std::vector<CameraSpots> exposures = shuffled(rig, points, 0.05, rng);
        CHECK(match_spots(rig.cameras, exposures, none_of(exposures), {}).empty());
        const std::vector<MatchedPoint> matched = match_spots(rig.cameras, exposures, none_of(exposures), two);
        matched_in_all += static_cast<int>(matched.size());
        CHECK(matched.size() <= 12);
    }
    CHECK(matched_in_all > 200);
}

TEST_CASE("spots that are another's are left out") {
    const Rig rig = small_rig();
    Rng rng(8);
    const std::vector<CameraSpots> exposures = shuffled(rig, {{10, 0, 0}}, 0.0, rng);
    std::vector<std::vector<bool>> taken = none_of(exposures);
    CHECK(match_spots(rig.cameras, exposures, taken, {}).size() == 1);
    for (std::size_t i = 0; i < 4; ++i) {
        taken[i][0] = true;
    }
    CHECK(match_spots(rig.cameras, exposures, taken, {}).empty());
}

}  // namespace rhexis::tracking
