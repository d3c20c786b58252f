// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <opencv2/calib3d.hpp>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "tracking/camera.hpp"

namespace rhexis::tracking {
namespace {

Camera some_camera() {
    Camera camera;
    camera.name = "left";
    camera.width = 1280;
    camera.height = 1024;
    camera.lens = {1667.0, 1669.0, 645.0, 509.0, -0.12, 0.08, 4e-4, -3e-4, 0.02};
    camera.pose.position = {310.0, -40.0, 420.0};
    camera.pose.orientation = turn_of_z(-camera.pose.position);
    return camera;
}

}  // namespace

TEST_CASE("a point's image is where OpenCV has it, and its ray goes through it") {
    const Camera camera = some_camera();
    const Lens& lens = camera.lens;
    const cv::Matx33d matrix(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
    const std::vector<double> bends{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = 150.0 * (2.0 * uniform3(rng) - Vec3::Ones());
        const Vec3 seen = camera.pose.to_body(point);
        std::vector<cv::Point2d> theirs;
        cv::projectPoints(std::vector<cv::Point3d>{{seen.x(), seen.y(), seen.z()}}, cv::Vec3d(0, 0, 0),
                          cv::Vec3d(0, 0, 0), matrix, bends, theirs);
        const std::optional<Vec2> ours = project(camera, point);
        REQUIRE(ours.has_value());
        CHECK((*ours - Vec2(theirs[0].x, theirs[0].y)).norm() < 1e-9);
        const Ray ray = ray_of(camera, *ours);
        CHECK((point - ray.from).cross(ray.along).norm() < 1e-8);
    }
    CHECK_FALSE(project(camera, camera.pose.to_world({0, 0, -5})).has_value());
}

TEST_CASE("how an image moves with its point is the difference of two images") {
    const Camera camera = some_camera();
    const Vec3 point{20.0, -60.0, 400.0};
    const Eigen::Matrix<double, 2, 3> slope = projection_slope(camera.lens, point);
    constexpr double step = 1e-4;
    for (int i = 0; i < 3; ++i) {
        const Vec3 more = point + step * Vec3::Unit(i);
        const Vec3 less = point - step * Vec3::Unit(i);
        const Vec2 moved =
            (distorted(camera.lens, more.head<2>() / more.z()) - distorted(camera.lens, less.head<2>() / less.z())) /
            (2.0 * step);
        CHECK((slope.col(i) - moved).norm() < 1e-6);
    }
}

}  // namespace rhexis::tracking
