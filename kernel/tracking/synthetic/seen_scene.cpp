// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/seen_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "math/poses.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// In worn patches, whose edge is a little soft.
double light_left(const Sphere& sphere, const Vec3& normal) {
    constexpr double edge = 0.05;
    if (sphere.worn_cosine > 1.0) {
        return 1.0;
    }
    const double inside = smooth_step((normal.dot(sphere.worn_towards) - sphere.worn_cosine) / edge + 0.5);
    return 1.0 + inside * (sphere.worn_left - 1.0);
}

double share_past(const Scene& seen, const Hiders& hiders, const Vec3& point, double distance, const Vec3& along,
                  double angle) {
    double share = 1.0;
    for (const int other : hiders.spheres) {
        const Hit nearer = hit(seen.spheres[at(other)], along, angle);
        if (nearer.distance < distance) {
            share *= 1.0 - nearer.share;
        }
    }
    for (const int capsule : hiders.capsules) {
        share *= light_past(seen.capsules[at(capsule)], Vec3::Zero(), point);
    }
    for (const int disc : hiders.discs) {
        share *= light_past(seen.discs[at(disc)], Vec3::Zero(), point);
    }
    return share;
}

}  // namespace

void seen_from(const Pose& camera, const Scene& scene, Scene& seen) {
    seen = scene;
    const Quat back = camera.orientation.conjugate();
    for (Sphere& sphere : seen.spheres) {
        sphere.centre = camera.to_body(sphere.centre);
        sphere.worn_towards = back * sphere.worn_towards;
    }
    for (Capsule& capsule : seen.capsules) {
        capsule.from = camera.to_body(capsule.from);
        capsule.to = camera.to_body(capsule.to);
    }
    for (Disc& disc : seen.discs) {
        disc.centre = camera.to_body(disc.centre);
        disc.normal = back * disc.normal;
    }
    for (Glint& glint : seen.glints) {
        glint.at = camera.to_body(glint.at);
    }
    for (Board& board : seen.boards) {
        board.pose = relative(camera, board.pose);
    }
}

void find_hiders(const Scene& seen, int sphere, Hiders& hiders) {
    hiders.spheres.clear();
    hiders.capsules.clear();
    hiders.discs.clear();
    const Sphere& hidden = seen.spheres[at(sphere)];
    const double distance = hidden.centre.norm();
    const double radius = hidden.radius;
    for (int i = 0; i < static_cast<int>(seen.spheres.size()); ++i) {
        const Sphere& other = seen.spheres[at(i)];
        const double other_distance = other.centre.norm();
        // small angles are a little smaller than their tangents: a tenth to spare
        const double reach = 1.1 * (radius / distance + other.radius / other_distance);
        if (i != sphere && other_distance < distance &&
            (hidden.centre / distance - other.centre / other_distance).norm() < reach) {
            hiders.spheres.push_back(i);
        }
    }
    for (int i = 0; i < static_cast<int>(seen.capsules.size()); ++i) {
        if (may_hide(seen.capsules[at(i)], Vec3::Zero(), hidden.centre, radius)) {
            hiders.capsules.push_back(i);
        }
    }
    for (int i = 0; i < static_cast<int>(seen.discs.size()); ++i) {
        if (may_hide(seen.discs[at(i)], Vec3::Zero(), hidden.centre, radius)) {
            hiders.discs.push_back(i);
        }
    }
}

Hit hit(const Sphere& sphere, const Vec3& along, double angle) {
    const double length2 = along.squaredNorm();
    const double towards = along.dot(sphere.centre);
    const double radius2 = sphere.radius * sphere.radius;
    const double centre2 = sphere.centre.squaredNorm();
    const double chord2 = radius2 - centre2 + towards * towards / length2;
    const double soft = angle * std::sqrt(centre2);
    if (towards <= 0.0 || chord2 < -2.0 * sphere.radius * soft) {
        return {};
    }
    Hit result;
    result.share = chord2 >= 0.0 ? 1.0 : 0.0;
    if (std::abs(chord2) < 2.0 * sphere.radius * soft) {
        const double inside = sphere.radius - std::sqrt(radius2 - chord2);
        result.share = std::clamp(inside / soft + 0.5, 0.0, 1.0);
    }
    result.cosine2 = std::max(0.0, chord2) / radius2;
    result.distance = towards / length2 - std::sqrt(std::max(0.0, chord2) / length2);
    return result;
}

Shine shine(const Scene& seen, int sphere, const Hiders& hiders, const Vec3& along, double angle) {
    const Sphere& it = seen.spheres[at(sphere)];
    const Hit met = hit(it, along, angle);
    if (met.share <= 0.0) {
        return {};
    }
    Shine result;
    result.share = met.share;
    // the ring light at the camera is as far as the camera, for the sphere as a whole
    const double distance2 = it.centre.squaredNorm() / (light_at_mm * light_at_mm);
    double light = it.light * (1.0 - it.lobe * (1.0 - met.cosine2)) / distance2;
    if (!hiders.none() || it.worn_cosine <= 1.0) {
        const Vec3 point = met.distance * along;
        result.share *= share_past(seen, hiders, point, met.distance, along, angle);
        light *= light_left(it, (point - it.centre) / it.radius);
    }
    result.light = result.share * light;
    return result;
}

}  // namespace rhexis::tracking::synthetic
