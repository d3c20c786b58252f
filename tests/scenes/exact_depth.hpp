// SPDX-License-Identifier: GPL-3.0-or-later
// The optical depth of a frame by exact ray casting, and where a picture may differ from it: along silhouettes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

/// Pixels within one pixel of a place where the line of sight grazes a face that is drawn: an edge between a face seen
/// from the front and one seen from behind, or the edge of a face within 6 degrees of edge-on; or the rim of an
/// instrument.
class Silhouette {
public:
    Silhouette(const Frame& frame, const View& view, const ExactDepth& exact)
        : view_(view), near_(static_cast<std::size_t>(view.width) * view.height, false) {
        for (std::size_t i = 0; i < frame.solids.size(); ++i) {
            FaceStream faces;
            std::vector<Vec3> fine;
            append_signed_faces(frame.model->solids[i], frame.solids[i], fine, faces);
            add_faces(faces);
        }
        mark_edges();
        mark_rims(exact.stop);
    }
    [[nodiscard]] bool near(int x, int y) const { return near_[static_cast<std::size_t>(y) * view_.width + x]; }

private:
    using Key = std::array<float, 3>;
    struct Sides {
        int front = 0;
        int back = 0;
    };

    void add_faces(const FaceStream& faces) {
        for (std::size_t i = 0; i + 17 < faces.size(); i += 18) {
            std::array<Key, 3> corner;
            std::array<Vec2, 3> pixel;
            for (int k = 0; k < 3; ++k) {
                corner[k] = {faces[i + 6 * k], faces[i + 6 * k + 1], faces[i + 6 * k + 2]};
                pixel[k] = pixel_of(view_, Vec3(corner[k][0], corner[k][1], corner[k][2]));
            }
            const Vec2 u = pixel[1] - pixel[0];
            const Vec2 v = pixel[2] - pixel[0];
            const bool front = u.x() * v.y() - u.y() * v.x() < 0.0;
            const bool grazed = std::abs(facing(corner, pixel[0])) < 0.1;
            for (int k = 0; k < 3; ++k) {
                Sides& sides = edges_[std::minmax(corner[k], corner[(k + 1) % 3])];
                sides.front += front || grazed;
                sides.back += !front || grazed;
            }
        }
    }

    /// Cosine of the angle between a face's normal and the line of sight.
    [[nodiscard]] double facing(const std::array<Key, 3>& corner, const Vec2& pixel) const {
        const Vec3 a(corner[0][0], corner[0][1], corner[0][2]);
        const Vec3 b(corner[1][0], corner[1][1], corner[1][2]);
        const Vec3 c(corner[2][0], corner[2][1], corner[2][2]);
        const Ray ray = pixel_ray(view_, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
        return (b - a).cross(c - a).normalized().dot(ray.direction);
    }

    void mark_edges() {
        for (const auto& [edge, sides] : edges_) {
            if (sides.front == 0 || sides.back == 0) {
                continue;
            }
            const Vec2 a = pixel_of(view_, Vec3(edge.first[0], edge.first[1], edge.first[2]));
            const Vec2 b = pixel_of(view_, Vec3(edge.second[0], edge.second[1], edge.second[2]));
            const int steps = 1 + static_cast<int>(4.0 * (b - a).norm());
            for (int i = 0; i <= steps; ++i) {
                mark(a + (b - a) * i / steps);
            }
        }
    }

    void mark(const Vec2& place) {
        const int left = static_cast<int>(std::floor(place.x() - 1.5));
        const int top = static_cast<int>(std::floor(place.y() - 1.5));
        for (int y = top; y <= top + 3; ++y) {
            for (int x = left; x <= left + 3; ++x) {
                if ((Vec2(x + 0.5, y + 0.5) - place).norm() <= 1.0) {
                    set(x, y);
                }
            }
        }
    }

    void mark_rims(const std::vector<double>& stop) {
        for (int y = 0; y + 1 < view_.height; ++y) {
            for (int x = 0; x + 1 < view_.width; ++x) {
                const std::size_t here = static_cast<std::size_t>(y) * view_.width + x;
                for (std::size_t other : {here + 1, here + view_.width}) {
                    const bool both = std::isfinite(stop[here]) && std::isfinite(stop[other]);
                    const bool none = !std::isfinite(stop[here]) && !std::isfinite(stop[other]);
                    if (!none && (!both || std::abs(stop[here] - stop[other]) > 0.25)) {
                        set(x, y);
                        set(x + (other == here + 1), y + (other != here + 1));
                    }
                }
            }
        }
    }

    void set(int x, int y) {
        if (x >= 0 && y >= 0 && x < view_.width && y < view_.height) {
            near_[static_cast<std::size_t>(y) * view_.width + x] = true;
        }
    }

    View view_;
    std::vector<bool> near_;
    std::map<std::pair<Key, Key>, Sides> edges_;
};

/// Difference of a picture from the exact optical depth, away from silhouettes.
struct DepthError {
    double rms = 0.0;
    double largest = 0.0;
    double largest_anywhere = 0.0;  ///< silhouettes included
    double largest_tau = 0.0;
    int compared = 0;    ///< pixels that see the body
    int silhouette = 0;  ///< pixels left out
};

inline DepthError compare(const OpticalDepth& picture, const ExactDepth& exact, const Silhouette& silhouette) {
    DepthError error;
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * picture.width + x;
            const Vec3 drawn(picture.tau[3 * pixel], picture.tau[3 * pixel + 1], picture.tau[3 * pixel + 2]);
            const double worst = (drawn - exact.tau[pixel]).cwiseAbs().maxCoeff();
            error.largest_anywhere = std::max(error.largest_anywhere, worst);
            if (silhouette.near(x, y)) {
                ++error.silhouette;
                continue;
            }
            error.compared += exact.tau[pixel].maxCoeff() > 0.0;
            sum += (drawn - exact.tau[pixel]).squaredNorm();
            error.largest = std::max(error.largest, worst);
            error.largest_tau = std::max(error.largest_tau, exact.tau[pixel].maxCoeff());
        }
    }
    error.rms = std::sqrt(sum / (3.0 * std::max(1, error.compared)));
    return error;
}

}  // namespace rhexis::testing
