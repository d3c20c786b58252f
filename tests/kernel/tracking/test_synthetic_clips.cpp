// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <numbers>
#include <set>

#include "base/hash.hpp"
#include "base/rng.hpp"
#include "support/sanitized.hpp"
#include "tracking/synthetic/bodies.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/synthetic/marker_spots.hpp"
#include "tracking/synthetic/renderer.hpp"

namespace rhexis::tracking::synthetic {
namespace {

const SyntheticRig& some_rig() {
    static const SyntheticRig rig = SyntheticRig::create(21).value();
    return rig;
}

Clip clip_named(std::string_view name, std::uint64_t seed = 1) {
    const std::vector<MarkerBody> bodies = standard_bodies();
    return make_clip(name, seed, bodies, some_rig().nominal).value();
}

/// To a millionth of a millimetre, which the last bits of a sine do not reach.
std::uint64_t hash_of_poses(const Clip& clip) {
    StateHash hash;
    const auto add = [&](double value) { hash.add(static_cast<std::uint64_t>(std::llround(value * 1e6))); };
    for (int body = 0; body < static_cast<int>(clip.bodies.size()); ++body) {
        for (int i = 0; i < 50; ++i) {
            const Pose pose = pose_at(clip, body, 0.217 * i);
            for (int j = 0; j < 3; ++j) {
                add(pose.position[j]);
            }
            for (int j = 0; j < 4; ++j) {
                add(pose.orientation.coeffs()[j]);
            }
        }
    }
    return hash.value();
}

std::uint64_t hash_of_images(std::uint64_t seed) {
    RigOptions options;
    options.cameras = 2;
    options.width = 320;
    options.height = 256;
    options.focal_px = 417.0;
    const SyntheticRig rig = SyntheticRig::create(seed, options).value();
    const std::vector<MarkerBody> bodies = standard_bodies();
    const Clip clip = make_clip("insertions", seed, bodies, rig.nominal).value();
    const std::vector<Shot> all = shots(rig, {}, 2, seed).value();
    StateHash hash;
    RenderScratch scratch;
    Image image;
    std::vector<Scene> instants;
    for (const Shot& shot : all) {
        const TrueCamera camera = camera_at(clip, rig, shot.camera, shot.exposed_s);
        instants_of(clip, shot, 1e-3, 3, instants);
        render(camera, SensorPattern(camera, seed), instants, static_cast<std::uint64_t>(shot.frame), scratch, image);
        hash.add_bytes(image.pixels.data(), image.pixels.size());
    }
    return hash.value();
}

/// Spheres of a body that a camera has a spot of.
std::set<int> seen_spheres(const Clip& clip, int camera, double time_s) {
    Scene scene;
    scene_at(clip, time_s, scene);
    SpotScratch scratch;
    std::vector<Spot> spots;
    Rng rng(1);
    spots_without_images(camera_at(clip, some_rig(), camera, time_s), {&scene, 1}, {}, rng, scratch, spots);
    std::set<int> seen(scratch.sphere_of.begin(), scratch.sphere_of.end());
    seen.erase(-1);
    return seen;
}

double greatest_speed(const Clip& clip, int body) {
    constexpr double step = 1e-4;
    double greatest = 0.0;
    for (double time = 0.0; time < 1.0; time += 0.001) {
        const Vec3 moved = tip_at(clip, body, time + step).position - tip_at(clip, body, time).position;
        greatest = std::max(greatest, moved.norm() / step);
    }
    return greatest;
}

}  // namespace

TEST_CASE("the standard bodies' distances all differ by 2 mm, and no body is flat") {
    std::vector<double> distances;
    for (const MarkerBody& body : standard_bodies()) {
        REQUIRE(body.markers.size() == 4);
        Mat3 edges;
        Vec3 centre = Vec3::Zero();
        double greatest = 0.0;
        for (int i = 0; i < 4; ++i) {
            centre += 0.25 * body.markers[static_cast<std::size_t>(i)];
            for (int j = 0; j < i; ++j) {
                const Vec3 edge = body.markers[static_cast<std::size_t>(i)] - body.markers[static_cast<std::size_t>(j)];
                distances.push_back(edge.norm());
                greatest = std::max(greatest, edge.norm());
            }
            if (i > 0) {
                edges.col(i - 1) = body.markers[static_cast<std::size_t>(i)] - body.markers[0];
            }
        }
        CHECK(centre.norm() < 0.01);
        CHECK(std::abs(edges.determinant()) / 6.0 > 1000.0);
        CHECK((body.name == "head" || (greatest > 30.0 && greatest < 60.0)));
        CHECK(body.tip.position.norm() > 75.0);
        CHECK(body.tip.position.norm() < 125.0);
        const Result<MarkerBody> file = read_marker_body("assets/tracking/bodies/" + body.name + ".json");
        REQUIRE(file.ok());
        CHECK(file.value().markers == body.markers);
        CHECK(file.value().tip.position == body.tip.position);
    }
    std::sort(distances.begin(), distances.end());
    for (std::size_t i = 1; i < distances.size(); ++i) {
        CHECK(distances[i] - distances[i - 1] > 2.0);
    }
}

TEST_CASE("a clip is the same for the same seed, today and later, and another for another") {
    CHECK(hex(hash_of_poses(clip_named("tremor"))) == "1efc66fd0302bc7b");
    CHECK(hex(hash_of_poses(clip_named("knocks"))) == "941189bf5c1a2064");
    CHECK(hash_of_poses(clip_named("tremor", 2)) != hash_of_poses(clip_named("tremor")));
    CHECK(hash_of_images(7) == hash_of_images(7));
    CHECK(hash_of_images(7) != hash_of_images(8));
    const std::vector<MarkerBody> bodies = standard_bodies();
    const Result<Clip> none = make_clip("dance", 1, bodies, some_rig().nominal);
    REQUIRE_FALSE(none.ok());
    CHECK(none.error().text().find("insertions") != std::string::npos);
}

TEST_CASE("clips move as their names say, and the head only where they say so") {
    for (const std::string_view name : clip_names) {
        const double speed = greatest_speed(clip_named(name), 0);
        if (name == "breathing") {
            CHECK(speed > 0.05);
            CHECK(speed < 2.0 * std::numbers::pi * (0.5 * 0.05 + 0.2 * 0.25));
        } else if (name == "knocks") {
            CHECK(speed == doctest::Approx(1.5 * 1.0 / 0.1).epsilon(0.05));
        } else {
            CHECK(speed == 0.0);
        }
    }
    const Clip knocks = clip_named("knocks");
    const Vec3 before = tip_at(knocks, 0, 0.14).position;
    const double pushed = (tip_at(knocks, 0, 0.7).position - before).norm();
    CHECK(pushed == doctest::Approx(1.0).epsilon(0.35));  // while it drifts and breathes
    CHECK(greatest_speed(clip_named("still"), 1) == 0.0);
    CHECK(greatest_speed(clip_named("circle"), 1) == doctest::Approx(2.0 * std::numbers::pi).epsilon(0.001));
    CHECK(greatest_speed(clip_named("insertions"), 2) == doctest::Approx(500.0).epsilon(0.01));
    const Clip pivot = clip_named("pivot");
    CHECK(greatest_speed(pivot, 1) == 0.0);
    const double swung = tip_at(pivot, 1, 0.0).orientation.angularDistance(tip_at(pivot, 1, 1.25).orientation);
    CHECK(swung == doctest::Approx(0.7).epsilon(0.05));
    const Clip tremor = clip_named("tremor");
    const Motion& motion = tremor.motions[1];
    double square = 0.0;
    for (const Wave& wave : motion.moves) {
        if (wave.frequency_hz > 5.0) {
            CHECK(wave.frequency_hz >= 6.0);
            CHECK(wave.frequency_hz <= 14.0);
            square += wave.amplitude.squaredNorm();
        }
    }
    CHECK(std::sqrt(square) == doctest::Approx(0.05));
    for (const MarkerBody& body : tremor.bodies) {
        const int index = static_cast<int>(&body - tremor.bodies.data());
        const Vec3 by_pose = pose_at(tremor, index, 1.3).to_world(body.tip.position);
        CHECK((by_pose - tip_at(tremor, index, 1.3).position).norm() < 1e-9);
    }
}

TEST_CASE("at rest every marker is seen by three cameras or more") {
    const Clip clip = clip_named("still");
    std::vector<int> views(16, 0);
    for (int camera = 0; camera < 6; ++camera) {
        for (const int sphere : seen_spheres(clip, camera, 1.0)) {
            ++views[static_cast<std::size_t>(sphere)];
        }
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        CAPTURE(i);
        CHECK(views[i] >= 3);
    }
}

TEST_CASE("covered cameras see nothing and others do; a covered marker is seen by none, before and after by some") {
    const Clip clip = clip_named("occlusion");
    std::set<std::set<int>> choices;
    int markers = 0;
    for (const Cover& cover : clip.covers) {
        const double middle = 0.5 * (cover.begin_s + cover.end_s);
        std::set<int> seeing;
        bool covered_seen = false;
        bool seen_before = false;
        for (int camera = 0; camera < 6; ++camera) {
            const std::set<int> seen = seen_spheres(clip, camera, middle);
            if (!seen.empty()) {
                seeing.insert(camera);
            }
            const int sphere = 4 * cover.body + cover.marker;
            covered_seen = covered_seen || seen.contains(sphere);
            seen_before = seen_before || seen_spheres(clip, camera, cover.begin_s - 0.01).contains(sphere);
        }
        if (cover.camera >= 0) {
            CHECK_FALSE(seeing.contains(cover.camera));
            CHECK(seeing.size() == 2);
            choices.insert(seeing);
        } else {
            CHECK_FALSE(covered_seen);
            CHECK(seen_before);
            ++markers;
        }
    }
    CHECK(choices.size() == 15);
    CHECK(markers == 16);
}

TEST_CASE("two instruments cross in some view, and leave the volume together and return") {
    const Clip clip = clip_named("crossing");
    bool crossed = false;
    for (double time = 0.0; time < 6.0; time += 0.05) {
        for (int camera = 0; camera < 6; ++camera) {
            const TrueCamera it = camera_at(clip, some_rig(), camera, time);
            for (const Vec3& one : clip.bodies[1].markers) {
                for (const Vec3& other : clip.bodies[2].markers) {
                    const std::optional<Vec2> a = project(it, pose_at(clip, 1, time).to_world(one));
                    const std::optional<Vec2> b = project(it, pose_at(clip, 2, time).to_world(other));
                    crossed = crossed || (a && b && (*a - *b).norm() < 15.0);
                }
            }
        }
    }
    CHECK(crossed);
    for (const double time : {6.5, 8.5, 11.0}) {
        std::vector<int> views(16, 0);
        for (int camera = 0; camera < 6; ++camera) {
            for (const int sphere : seen_spheres(clip, camera, time)) {
                ++views[static_cast<std::size_t>(sphere)];
            }
        }
        for (std::size_t i = 4; i < views.size(); ++i) {
            CAPTURE(time);
            CAPTURE(i);
            CHECK((time == 8.5 ? views[i] == 0 : views[i] >= 2));
        }
    }
}

TEST_CASE("a bump turns one camera by a tenth of a degree from its time on, and no other") {
    const Clip clip = clip_named("bump");
    int moved = 0;
    for (int camera = 0; camera < 6; ++camera) {
        const Quat before = camera_at(clip, some_rig(), camera, 4.9).pose.orientation;
        const Quat after = camera_at(clip, some_rig(), camera, 5.1).pose.orientation;
        const double degrees = before.angularDistance(after) * 180.0 / std::numbers::pi;
        CHECK(before.angularDistance(some_rig().cameras[static_cast<std::size_t>(camera)].pose.orientation) < 1e-9);
        if (degrees > 1e-6) {
            ++moved;
            CHECK(camera == clip.bump.camera);
            CHECK(degrees == doctest::Approx(0.1).epsilon(1e-4));
        }
    }
    CHECK(moved == 1);
}

TEST_CASE("frames are lost, late and skewed as often and far as said, and none are otherwise") {
    Delivery delivery;
    constexpr int frames = 2000;
    const std::vector<Shot> all = shots(some_rig(), delivery, frames, 1).value();
    CHECK(all.size() == 6 * frames);
    delivery.lost = 0.1;
    delivery.late = 0.05;
    delivery.skew_s = 5e-3;
    const std::vector<Shot> fewer = shots(some_rig(), delivery, frames, 1).value();
    CHECK(static_cast<double>(fewer.size()) == doctest::Approx(0.9 * 6 * frames).epsilon(0.01));
    int late = 0;
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        const Shot& shot = fewer[i];
        CHECK((i == 0 || fewer[i - 1].arrives_s <= shot.arrives_s));
        const TrueCamera& camera = some_rig().cameras[static_cast<std::size_t>(shot.camera)];
        CHECK(shot.exposed_s - shot.time_s == doctest::Approx(camera.time_offset_s).epsilon(1e-3));
        CHECK(shot.time_s ==
              doctest::Approx(static_cast<double>(shot.frame) / 120.0 + 1e-3 * shot.camera).epsilon(1e-9));
        late += shot.arrives_s - shot.exposed_s > 20e-3 ? 1 : 0;
    }
    CHECK(late == doctest::Approx(0.05 * 0.9 * 6 * frames).epsilon(0.15));
    delivery.lost = 1.5;
    const Result<std::vector<Shot>> refused = shots(some_rig(), delivery, 1, 1);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().text().find("lost") != std::string::npos);
}

}  // namespace rhexis::tracking::synthetic
