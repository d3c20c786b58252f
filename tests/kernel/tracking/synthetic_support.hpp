// SPDX-License-Identifier: GPL-3.0-or-later
// Centroids of one sphere's image, as plainly as can be, and a camera to look with.
#pragma once

#include <vector>

#include "tracking/synthetic/renderer.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking::synthetic {

struct LightMoments {
    double sum = 0.0;
    Vec2 mean = Vec2::Zero();
    Mat2 spread = Mat2::Zero();
};

inline LightMoments moments_of(const LightField& field) {
    LightMoments result;
    Mat2 second = Mat2::Zero();
    for (int y = 0; y < field.height; ++y) {
        for (int x = 0; x < field.width; ++x) {
            const double light = field.light[static_cast<std::size_t>(y * field.width + x)];
            const Vec2 place(x, y);
            result.sum += light;
            result.mean += light * place;
            second += light * place * place.transpose();
        }
    }
    if (result.sum > 0.0) {
        result.mean /= result.sum;
        result.spread = second / result.sum - result.mean * result.mean.transpose();
    }
    return result;
}

/// Of the pixels about `near` that are brighter than `threshold`, weighted by what they have above `background`.
inline Vec2 centroid_near(const Image& image, const Vec2& near, int reach, double background, double threshold) {
    double sum = 0.0;
    Vec2 first = Vec2::Zero();
    const Window part = within({static_cast<int>(near.x()) - reach, static_cast<int>(near.y()) - reach,
                                static_cast<int>(near.x()) + reach + 1, static_cast<int>(near.y()) + reach + 1},
                               image.width, image.height);
    for (int y = part.top; y < part.bottom; ++y) {
        for (int x = part.left; x < part.right; ++x) {
            const double value = image.pixels[static_cast<std::size_t>(y * image.width + x)];
            if (value > threshold) {
                sum += value - background;
                first += (value - background) * Vec2(x, y);
            }
        }
    }
    return first / sum;
}

/// At the rig's origin, looking along +z: without distortion and vignetting, sharp everywhere alike.
inline TrueCamera plain_camera(int width = 320, int height = 256) {
    TrueCamera camera;
    camera.name = "plain";
    camera.width = width;
    camera.height = height;
    camera.lens.fx = 1667.0;
    camera.lens.fy = 1667.0;
    camera.lens.cx = 0.5 * (width - 1);
    camera.lens.cy = 0.5 * (height - 1);
    camera.optics = {0.6, 0.0, 450.0, 0.0, 0.0, 0.5};
    camera.sensor.fixed_pattern = 0.0;
    camera.sensor.response_spread = 0.0;
    return camera;
}

/// One evenly bright sphere.
inline Scene one_sphere(const Vec3& centre) {
    Scene scene;
    Sphere sphere;
    sphere.centre = centre;
    sphere.lobe = 0.0;
    scene.spheres.push_back(sphere);
    return scene;
}

}  // namespace rhexis::tracking::synthetic
