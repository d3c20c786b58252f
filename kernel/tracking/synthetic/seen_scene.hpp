// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as one camera has it before it: in the camera's own frame, with what may hide each sphere.
#pragma once

#include <vector>

#include "tracking/synthetic/scene.hpp"
#include "tracking/synthetic/sensor.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

/// In the camera's frame; spheres, capsules, discs and boards in the order of the scene.
void seen_from(const Pose& camera, const Scene& scene, Scene& seen);

/// What stands between the camera, at the origin, and one sphere: indices.
struct Hiders {
    std::vector<int> spheres{};
    std::vector<int> capsules{};
    std::vector<int> discs{};

    [[nodiscard]] bool none() const { return spheres.empty() && capsules.empty() && discs.empty(); }
};
void find_hiders(const Scene& seen, int sphere, Hiders& hiders);

/// Where the ray to `along` (its length does not matter) meets a sphere. The ray stands for a sample as wide as
/// `angle` [rad]: at the limb the sphere fills a part of it.
struct Hit {
    double share = 0.0;     ///< of the sample that it fills; 0: it is not met
    double distance = 0.0;  ///< to it, in lengths of `along`
    double cosine2 = 0.0;   ///< square of the cosine between ray and the sphere's normal there
};
Hit hit(const Sphere& sphere, const Vec3& along, double angle = 0.0);

/// Light of a sphere where a ray meets it, past what hides it, with its distance to the camera; 0 to sphere.light but
/// for the distance. `share` is what is seen of it there, 0 to 1.
struct Shine {
    double light = 0.0;
    double share = 0.0;
};
Shine shine(const Scene& seen, int sphere, const Hiders& hiders, const Vec3& along, double angle = 0.0);

}  // namespace rhexis::tracking::synthetic
