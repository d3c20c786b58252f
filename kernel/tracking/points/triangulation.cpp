// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/points/triangulation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace rhexis::tracking {
namespace {

const Camera& camera_of(std::span<const Camera> cameras, const View& view) {
    return cameras[static_cast<std::size_t>(view.camera)];
}

/// The point whose distances to all rays have the least sum of squares.
std::optional<Vec3> nearest_to_rays(std::span<const Camera> cameras, std::span<const View> views) {
    constexpr double least_turn = 0.017;  // between rays, 1 degree
    Mat3 across = Mat3::Zero();
    Vec3 sum = Vec3::Zero();
    for (const View& view : views) {
        const Ray ray = ray_of(camera_of(cameras, view), view.at);
        const Mat3 one = Mat3::Identity() - ray.along * ray.along.transpose();
        across += one;
        sum += one * ray.from;
    }
    // Of rays that are parallel the mean of these projections has a zero eigenvalue; of two at an angle a it is
    // 1 - cos(a), for small angles a^2 / 2.
    Eigen::SelfAdjointEigenSolver<Mat3> eigen;
    eigen.computeDirect(across, Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues()[0] < 0.5 * least_turn * least_turn) {
        return std::nullopt;
    }
    return across.ldlt().solve(sum);
}

}  // namespace

std::optional<Triangulated> triangulate(std::span<const Camera> cameras, std::span<const View> views) {
    constexpr int steps = 2;
    if (views.size() < 2) {
        return std::nullopt;
    }
    const std::optional<Vec3> begun = nearest_to_rays(cameras, views);
    if (!begun) {
        return std::nullopt;
    }
    Triangulated result{*begun, 0.0};
    for (int step = 0; step <= steps; ++step) {
        Mat3 normal = Mat3::Zero();
        Vec3 slope = Vec3::Zero();
        double squares = 0.0;
        for (const View& view : views) {
            const Camera& camera = camera_of(cameras, view);
            const Vec3 seen = camera.pose.to_body(result.point);
            if (seen.z() <= 1.0) {
                return std::nullopt;
            }
            const Vec2 off = view.at - distorted(camera.lens, seen.head<2>() / seen.z());
            const Eigen::Matrix<double, 2, 3> moves =
                projection_slope(camera.lens, seen) * camera.pose.orientation.conjugate().toRotationMatrix();
            normal += moves.transpose() * moves;
            slope += moves.transpose() * off;
            squares += off.squaredNorm();
        }
        result.residual_px = std::sqrt(squares / static_cast<double>(views.size()));
        if (step < steps) {
            result.point += normal.ldlt().solve(slope);
        }
    }
    return result;
}

}  // namespace rhexis::tracking
