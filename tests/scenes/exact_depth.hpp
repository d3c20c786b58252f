// SPDX-License-Identifier: GPL-3.0-or-later
// The optical depth of a frame by exact ray casting, and how far a picture is from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/optical_path.hpp"
#include "render/renderer.hpp"
#include "render/signed_faces.hpp"
#include "render/tool_mesh.hpp"
#include "render/view.hpp"

namespace rhexis::testing {

struct ExactDepth {
    std::vector<Vec3> tau;
    std::vector<double> stop;  ///< distance to the first instrument from the start of the ray, or infinity
};

/// Distance along the ray to the first triangle in front of its start, or infinity.
inline double distance_to(const ToolMesh& mesh, const Pose& pose, const Vec3& origin, const Vec3& direction) {
    const Vec3 start = pose.to_body(origin);
    const Vec3 along = pose.orientation.conjugate() * direction;
    double nearest = std::numeric_limits<double>::infinity();
    for (const ToolMesh::Part& part : mesh.parts) {
        for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
            const Vec3& a = part.corners[i].place;
            const Vec3 u = part.corners[i + 1].place - a;
            const Vec3 v = part.corners[i + 2].place - a;
            const Vec3 p = along.cross(v);
            const double determinant = u.dot(p);
            if (std::abs(determinant) < 1e-14) {
                continue;
            }
            const Vec3 offset = start - a;
            const Vec3 q = offset.cross(u);
            const double s = offset.dot(p) / determinant;
            const double r = along.dot(q) / determinant;
            if (s >= 0.0 && r >= 0.0 && s + r <= 1.0) {
                const double distance = v.dot(q) / determinant;
                nearest = distance > 0.0 ? std::min(nearest, distance) : nearest;
            }
        }
    }
    return nearest;
}

inline Vec3 tau_along(const Frame& frame, const std::vector<std::vector<Vec3>>& extinction, const Vec3& origin,
                      const Vec3& direction, double limit) {
    Vec3 tau = Vec3::Zero();
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const SolidModel& model = frame.model->solids[i];
        const SolidState& state = frame.solids[i];
        std::vector<double> density = state.fraction;
        if (model.fine.tets.empty()) {
            density.assign(state.present.begin(), state.present.end());
        }
        tau += optical_depth_along(origin, direction,
                                   {model.coarse, model.fine, state.position, density, extinction[i]}, limit);
    }
    return tau;
}

inline ExactDepth exact_depth(const Frame& frame, const View& view) {
    std::vector<std::vector<Vec3>> extinction;
    for (const SolidModel& model : frame.model->solids) {
        extinction.push_back(coarse_extinction(model));
    }
    std::vector<ToolMesh> tools;
    for (const ToolModel& tool : frame.model->tools) {
        tools.push_back(tool_mesh(tool));
    }
    ExactDepth result;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const Ray ray = pixel_ray(view, x, y);
            const Vec3 origin = ray.at_plane - 40.0 * ray.direction;
            double stop = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < tools.size(); ++i) {
                if (frame.tools[i].present) {
                    stop = std::min(stop, distance_to(tools[i], frame.tools[i].pose, origin, ray.direction));
                }
            }
            result.stop.push_back(stop);
            result.tau.push_back(tau_along(frame, extinction, origin, ray.direction, stop));
        }
    }
    return result;
}

/// Difference of a picture from the exact optical depth, over all pixels, silhouettes included.
struct DepthError {
    double rms = 0.0;
    double largest = 0.0;
    double largest_tau = 0.0;
    int compared = 0;  ///< pixels that see the body
};

inline DepthError compare(const OpticalDepth& picture, const ExactDepth& exact) {
    DepthError error;
    double sum = 0.0;
    for (std::size_t pixel = 0; pixel < exact.tau.size(); ++pixel) {
        const Vec3 drawn(picture.tau[3 * pixel], picture.tau[3 * pixel + 1], picture.tau[3 * pixel + 2]);
        sum += (drawn - exact.tau[pixel]).squaredNorm();
        error.compared += exact.tau[pixel].maxCoeff() > 0.0;
        error.largest = std::max(error.largest, (drawn - exact.tau[pixel]).cwiseAbs().maxCoeff());
        error.largest_tau = std::max(error.largest_tau, exact.tau[pixel].maxCoeff());
    }
    error.rms = std::sqrt(sum / (3.0 * std::max(1, error.compared)));
    return error;
}

}  // namespace rhexis::testing
