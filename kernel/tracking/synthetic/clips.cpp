// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/clips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/rotation.hpp"

namespace rhexis::tracking::synthetic {
namespace {

Vec3 sum_at(const std::vector<Wave>& waves, double time_s) {
    Vec3 sum = Vec3::Zero();
    for (const Wave& wave : waves) {
        sum += std::sin(2.0 * std::numbers::pi * wave.frequency_hz * time_s + wave.phase) * wave.amplitude;
    }
    return sum;
}

/// 1 within, 0 outside, smoothly between.
double presence(double time_s, double begin_s, double end_s, double ramp_s) {
    return smooth_step((time_s - begin_s) / ramp_s) * smooth_step((end_s - time_s) / ramp_s);
}

/// At a body's tip, turned as the body: its handle lies along z.
Pose handle_at(const Clip& clip, int body, double time_s) {
    return {tip_at(clip, body, time_s).position, pose_at(clip, body, time_s).orientation};
}

/// Handle, and two fingers that hold it before the markers.
void add_hand(const Pose& held, double markers_mm, Scene& scene) {
    constexpr double handle_light = 6.0;
    constexpr double finger_light = 10.0;
    Capsule handle;
    handle.from = held.to_world({0.0, 0.0, 25.0});
    handle.to = held.to_world({0.0, 0.0, markers_mm + 25.0});
    handle.radius = 3.5;
    handle.light = handle_light;
    scene.capsules.push_back(handle);
    for (const double side : {-1.0, 1.0}) {
        Capsule finger;
        finger.from = held.to_world({side * 10.0, 0.0, 38.0});
        finger.to = held.to_world({side * 32.0, 30.0, 62.0});
        finger.radius = 6.5;
        finger.soft = 1.0;
        finger.light = finger_light;
        scene.capsules.push_back(finger);
    }
}

void add_microscope(Scene& scene) {
    Capsule column;
    column.from = {0.0, 0.0, 240.0};
    column.to = {0.0, 0.0, 480.0};
    column.radius = 45.0;
    column.soft = 1.0;
    column.light = 4.0;
    scene.capsules.push_back(column);
}

void add_cover(const Clip& clip, const Cover& cover, double time_s, Scene& scene) {
    if (time_s < cover.begin_s || time_s > cover.end_s) {
        return;
    }
    if (cover.camera < 0) {
        const MarkerBody& body = clip.bodies[at(cover.body)];
        Capsule ball;
        ball.from = pose_at(clip, cover.body, time_s).to_world(body.markers[at(cover.marker)]);
        ball.to = ball.from;
        ball.radius = body.radius_mm + 1.0;
        scene.capsules.push_back(ball);
        return;
    }
    constexpr double before_mm = 80.0;
    constexpr double radius = 90.0;
    const Vec3& eye = clip.eyes[at(cover.camera)];
    const double slid = 1.0 - presence(time_s, cover.begin_s, cover.end_s, cover.slide_s);
    const Vec3 towards = -eye.normalized();
    Disc disc;
    disc.centre = eye + before_mm * towards + 2.0 * radius * slid * towards.unitOrthogonal();
    disc.normal = towards;
    disc.radius = radius;
    disc.soft = 1.0;
    scene.discs.push_back(disc);
}

void add_glints(const Clip& clip, double time_s, Scene& scene) {
    constexpr double handle_mm = 4.2;  // just outside the handle's soft edge
    scene.glints.push_back({{62.0, -48.0, -18.0}, 90.0, 1.2});
    scene.glints.push_back({{-75.0, 30.0, -12.0}, 150.0, 0.8});
    for (int body = 0; body < static_cast<int>(clip.bodies.size()); ++body) {
        if (clip.bodies[at(body)].name != "head") {
            const Pose held = handle_at(clip, body, time_s);
            scene.glints.push_back({held.to_world({0.0, handle_mm, 72.0}), 120.0, 1.0});
        }
    }
}

}  // namespace

Pose tip_at(const Clip& clip, int body, double time_s) {
    const Motion& motion = clip.motions[at(body)];
    Pose tip = motion.tip;
    tip.position += sum_at(motion.moves, time_s);
    for (const Trip& trip : motion.trips) {
        tip.position += presence(time_s, trip.begin_s, trip.end_s, trip.ramp_s) * trip.to;
    }
    tip.orientation = turned(tip.orientation, sum_at(motion.turns, time_s));
    return tip;
}

Pose pose_at(const Clip& clip, int body, double time_s) {
    const Pose tip = tip_at(clip, body, time_s);
    const Pose& in_body = clip.bodies[at(body)].tip;
    Pose pose;
    pose.orientation = (tip.orientation * in_body.orientation.conjugate()).normalized();
    pose.position = tip.position - pose.orientation * in_body.position;
    return pose;
}

void scene_at(const Clip& clip, double time_s, Scene& scene) {
    scene.spheres.clear();
    scene.capsules.clear();
    scene.discs.clear();
    scene.glints.clear();
    scene.ambient = clip.ambient;
    scene.specks = clip.specks;
    for (int i = 0; i < static_cast<int>(clip.bodies.size()); ++i) {
        const MarkerBody& body = clip.bodies[at(i)];
        const Pose pose = pose_at(clip, i, time_s);
        for (std::size_t j = 0; j < body.markers.size(); ++j) {
            const Worn& worn = clip.worn[at(i)][j];
            Sphere sphere;
            sphere.centre = pose.to_world(body.markers[j]);
            sphere.radius = body.radius_mm;
            sphere.light = clip.marker_light;
            sphere.worn_towards = pose.orientation * worn.towards;
            sphere.worn_cosine = worn.cosine;
            sphere.worn_left = worn.left;
            scene.spheres.push_back(sphere);
        }
        if (clip.hands && body.name != "head") {
            add_hand({tip_at(clip, i, time_s).position, pose.orientation}, body.tip.position.norm(), scene);
        }
    }
    if (clip.hands) {
        add_microscope(scene);
    }
    if (clip.glints) {
        add_glints(clip, time_s, scene);
    }
    for (const Cover& cover : clip.covers) {
        add_cover(clip, cover, time_s, scene);
    }
}

TrueCamera camera_at(const Clip& clip, const SyntheticRig& rig, int camera, double time_s) {
    TrueCamera result = rig.cameras[at(camera)];
    if (clip.bump.camera == camera && time_s >= clip.bump.time_s) {
        result.pose.orientation = turned(result.pose.orientation, result.pose.orientation * clip.bump.turn);
    }
    return result;
}

void instants_of(const Clip& clip, const Shot& shot, double exposure_s, int count, std::vector<Scene>& instants) {
    RHEXIS_ASSERT(count > 0);
    instants.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        scene_at(clip, shot.exposed_s + exposure_s * ((i + 0.5) / count - 0.5), instants[at(i)]);
    }
}

}  // namespace rhexis::tracking::synthetic
