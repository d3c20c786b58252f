// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies that come with the program, all in one set: none is taken for another.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "small_rig.hpp"
#include "support/sanitized.hpp"
#include "tracking/bodies/identity.hpp"
#include "tracking/bodies/known_bodies.hpp"
#include "tracking/bodies/triangles.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

const std::vector<MarkerBody>& all_known() {
    static const std::vector<MarkerBody> bodies = [] {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator("assets/tracking/bodies")) {
            if (entry.path().stem() != head_name) {
                names.push_back(entry.path().stem().string());
            }
        }
        std::sort(names.begin(), names.end());
        return known_bodies(names).value();
    }();
    return bodies;
}

Vec3 chance_vector(Rng& rng) { return {rng.normal(), rng.normal(), rng.normal()}; }

/// Some bodies of a set, where they are, and which of their markers are seen.
struct Standing {
    std::vector<std::size_t> which{};
    std::vector<MarkerBody> seen{};  ///< with the markers that are seen, at least one
    std::vector<Pose> poses{};
};

Standing draw_standing(const std::vector<MarkerBody>& set, std::size_t most, double hidden, Rng& rng) {
    Standing standing;
    while (standing.which.size() < std::min(most, set.size())) {
        const auto body = static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(set.size()) - 1));
        if (std::find(standing.which.begin(), standing.which.end(), body) != standing.which.end()) {
            continue;
        }
        MarkerBody seen = set[body];
        std::erase_if(seen.markers, [&](const Vec3&) { return rng.uniform() < hidden; });
        standing.which.push_back(body);
        standing.seen.push_back(std::move(seen));
        standing.poses.push_back(pose_of(50.0 * chance_vector(rng), 2.0 * chance_vector(rng)));
    }
    return standing;
}

struct Judged {
    int right = 0;
    int missed = 0;  ///< of which three markers or more are seen
    int wrong = 0;
};

/// What a tracker that knows nothing yet says of one set of exposures.
void judge(const std::vector<MarkerBody>& set, const Standing& standing, const Rig& rig, Rng& rng, Judged& judged) {
    Tracker tracker(rig, set, std::nullopt, TrackerSettings{});
    const TrackedBodies& told = tracker.step(spots_of(rig, standing.seen, standing.poses, 1.0, 0.05, rng));
    for (std::size_t i = 0; i < set.size(); ++i) {
        const auto place = std::find(standing.which.begin(), standing.which.end(), i) - standing.which.begin();
        const bool there = place < static_cast<std::ptrdiff_t>(standing.which.size());
        const bool seen = told.bodies[i].seen == Seen::seen;
        if (seen && there) {
            const Pose& pose = standing.poses[static_cast<std::size_t>(place)];
            const Vec3 off = told.bodies[i].pose.to_world(set[i].tip.position) - pose.to_world(set[i].tip.position);
            (off.norm() < 1.0 ? judged.right : judged.wrong) += 1;
        } else if (seen) {
            judged.wrong += 1;
        } else if (there && standing.seen[static_cast<std::size_t>(place)].markers.size() >= 3) {
            judged.missed += 1;
        }
    }
}

}  // namespace

TEST_CASE("all bodies that come with the program pass the check in one set, each by the name of its file") {
    const Status status = check_signatures(all_known());
    CHECK_MESSAGE(status.ok(), (status ? "" : status.error().text()));
    for (const MarkerBody& body : all_known()) {
        CAPTURE(body.name);
        CHECK(std::filesystem::exists("assets/tracking/bodies/" + body.name + ".json"));
        CHECK(body.markers.size() == 4);
    }
    const std::vector<std::string> none{"scalpel"};
    CHECK(known_bodies(none).error().text().find("\"scalpel\"") != std::string::npos);
}

TEST_CASE("no three markers of a body are ever those of another, nor others of its own") {
    const double tolerance_mm = TrackerSettings{}.distance_mm;
    Rng rng(31);
    int own = 0;
    for (const MarkerBody& body : all_known()) {
        for (const MarkerTriangle& triangle : triangles_of(body.markers)) {
            std::vector<Vec3> points;
            for (const std::size_t marker : triangle.markers) {
                points.push_back(pose_of({10, 20, 30}, {1, 2, -1}).to_world(body.markers[marker]) +
                                 0.1 * chance_vector(rng));
            }
            for (const MarkerBody& other : all_known()) {
                const std::optional<Identified> found =
                    identify(other, points, std::vector<bool>(points.size(), false), tolerance_mm);
                if (&other != &body) {
                    CHECK_FALSE(found.has_value());
                } else if (found) {
                    ++own;
                    for (std::size_t i = 0; i < 3; ++i) {
                        CHECK(found->points[triangle.markers[i]] == static_cast<int>(i));
                    }
                }
            }
        }
    }
    CHECK(own > static_cast<int>(3 * all_known().size()));
}

TEST_CASE("of several bodies at chance places, with markers hidden, none is taken for another") {
    const Rig rig = small_rig();
    const int frames = rhexis::testing::sanitized ? 30 : 300;
    Rng rng(32);
    for (const double hidden : {0.0, 0.15, 0.35}) {
        Judged judged;
        for (int i = 0; i < frames; ++i) {
            judge(all_known(), draw_standing(all_known(), 4, hidden, rng), rig, rng, judged);
        }
        MESSAGE("hidden ", hidden, ": ", judged.right, " right, ", judged.missed, " missed, ", judged.wrong, " wrong");
        CHECK(judged.wrong == 0);
        CHECK(judged.right > 9 * judged.missed);
    }
}

TEST_CASE("three points that lie nearly as three of a body's markers do are not taken for it by their images") {
    const Rig rig = small_rig();
    const std::vector<MarkerBody> set{known_body("phaco").value()};
    MarkerBody others = set[0];
    others.markers.pop_back();
    const auto seen = [&](double off_mm, double most_px) {
        MarkerBody points = others;
        points.markers[0] += off_mm * (points.markers[0] - points.markers[1]).normalized();
        TrackerSettings settings;
        settings.most_new_px = most_px;
        Tracker tracker(rig, set, std::nullopt, settings);
        Rng rng(33);
        return tracker.step(spots_of(rig, {points}, {Pose{}}, 1.0, 0.05, rng)).bodies[0].seen == Seen::seen;
    };
    const TrackerSettings usual;
    CHECK(seen(0.0, usual.most_new_px));
    CHECK_FALSE(seen(0.2, usual.most_new_px));
    CHECK(seen(0.2, 0.6));
}

}  // namespace rhexis::tracking
