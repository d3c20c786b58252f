// SPDX-License-Identifier: GPL-3.0-or-later
// Wand calibration against a rig whose lenses bend light as the calibration's do not: thin prism terms are added.
#include <doctest/doctest.h>

#include <iostream>
#include <opencv2/calib3d.hpp>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "support/sanitized.hpp"
#include "tracking/calibration/wand.hpp"

namespace rhexis::tracking {
namespace {

Camera ring_camera(int i, int of) {
    const double angle = 2.0 * 3.14159265358979 * i / of;
    Camera camera;
    camera.name = "camera-" + std::to_string(i + 1);
    camera.width = 1280;
    camera.height = 1024;
    camera.lens = {1667.0, 1668.0, 642.0, 509.0, -0.11, 0.07, 3e-4, -2e-4, 0.01};
    camera.pose.position = Vec3(290.0 * std::cos(angle), 290.0 * std::sin(angle), 344.0);
    const Vec3 out = -camera.pose.position.normalized();
    Mat3 turned;
    turned.col(2) = out;
    turned.col(0) = Vec3::UnitZ().cross(out).normalized();
    turned.col(1) = out.cross(Vec3(turned.col(0)));
    camera.pose.orientation = Quat(turned);
    return camera;
}

Rig ring(int cameras) {
    Rig rig;
    for (int i = 0; i < cameras; ++i) {
        rig.cameras.push_back(ring_camera(i, cameras));
    }
    return rig;
}

/// The rig as its builder guessed it.
Rig guessed(const Rig& truth, double shift_mm, double turn, std::uint64_t seed = 5) {
    Rig rig = truth;
    Rng rng(seed, "guess");
    for (Camera& camera : rig.cameras) {
        const Vec3 axis = normal3(rng);
        camera.pose.position += shift_mm * normal3(rng) / std::sqrt(3.0);
        camera.pose.orientation = camera.pose.orientation * Quat(Eigen::AngleAxisd(turn, axis.normalized()));
    }
    return rig;
}

struct Waving {
    int frames = 600;
    double noise_px = 0.05;
    double prism = 5e-5;     ///< s1 and s3 of OpenCV's thin prism terms
    double outliers = 0.0;   ///< share of frames with one wrong spot
    double stretch = 1.0;    ///< true length of the wand over the one told
    double radius_mm = 0.0;  ///< of its spheres, whose images are ellipses
    std::uint64_t seed = 1;
};

std::vector<cv::Point2d> seen_through_prism(const Camera& camera, const std::vector<Vec3>& points, double prism,
                                            double radius_mm = 0.0) {
    const Lens& lens = camera.lens;
    std::vector<cv::Point3d> seen;
    for (const Vec3& point : points) {
        const Vec3 at = camera.pose.to_body(point);
        // a point whose image is the middle of the sphere's
        seen.emplace_back(at.x(), at.y(), at.z() - radius_mm * radius_mm / at.z());
    }
    const std::vector<double> bends{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, 0, 0, 0, prism, 0, -prism, 0};
    std::vector<cv::Point2d> images;
    cv::projectPoints(seen, cv::Vec3d(0, 0, 0), cv::Vec3d(0, 0, 0),
                      cv::Matx33d(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1), bends, images);
    return images;
}

std::vector<Vec3> wand_place(const Wand& wand, double stretch, Rng& rng) {
    const Vec3 middle = 70.0 * (2.0 * uniform3(rng) - Vec3::Ones());
    const Vec3 along = normal3(rng).normalized();
    std::vector<Vec3> points;
    for (const double at : wand.at_mm) {
        points.emplace_back(middle + stretch * (at - 0.5 * wand.length_mm()) * along);
    }
    return points;
}

bool inside(const Camera& camera, const cv::Point2d& at) {
    return at.x > 0 && at.y > 0 && at.x < camera.width - 1 && at.y < camera.height - 1;
}

/// Spots in a random order.
WandView view_of_wand(const Rig& rig, int camera, const std::vector<Vec3>& points, const Waving& waving, Rng& rng) {
    WandView view{camera, {}};
    const Camera& with = rig.cameras[static_cast<std::size_t>(camera)];
    for (const cv::Point2d& at : seen_through_prism(with, points, waving.prism, waving.radius_mm)) {
        if (inside(with, at)) {
            const Vec2 noise = waving.noise_px * normal2(rng);
            view.spots.emplace_back(at.x + noise.x(), at.y + noise.y());
        }
    }
    for (std::size_t i = view.spots.size(); i > 1; --i) {
        std::swap(view.spots[i - 1], view.spots[static_cast<std::size_t>(rng.integer(0, static_cast<int>(i) - 1))]);
    }
    return view;
}

std::vector<WandFrame> waved(const Rig& rig, const Wand& wand, const Waving& waving) {
    Rng rng(waving.seed, "wand");
    Rng wrong(waving.seed, "wrong");
    std::vector<WandFrame> frames;
    for (int i = 0; i < waving.frames; ++i) {
        const std::vector<Vec3> points = wand_place(wand, waving.stretch, rng);
        WandFrame frame;
        for (int camera = 0; camera < static_cast<int>(rig.cameras.size()); ++camera) {
            frame.views.push_back(view_of_wand(rig, camera, points, waving, rng));
        }
        std::vector<Vec2>& spots = frame.views[static_cast<std::size_t>(i) % frame.views.size()].spots;
        if (wrong.uniform() < waving.outliers && !spots.empty()) {
            spots[0] += Vec2(40.0 * wrong.normal(), 40.0 * wrong.normal());
        }
        frames.push_back(std::move(frame));
    }
    return frames;
}

/// Greatest distance of a camera from its true place, after rigid alignment [mm].
double place_error(const Rig& found, const Rig& truth) {
    MatX is(3, static_cast<Eigen::Index>(found.cameras.size()));
    MatX should(3, is.cols());
    for (Eigen::Index i = 0; i < is.cols(); ++i) {
        is.col(i) = found.cameras[static_cast<std::size_t>(i)].pose.position;
        should.col(i) = truth.cameras[static_cast<std::size_t>(i)].pose.position;
    }
    const Eigen::Matrix4d motion = Eigen::umeyama(is, should, false);
    const MatX moved = (motion.topLeftCorner<3, 3>() * is).colwise() + Vec3(motion.topRightCorner<3, 1>());
    return (moved - should).colwise().norm().maxCoeff();
}

Vec3 crossing(const Rig& rig, const std::vector<cv::Point2d>& images) {
    Mat3 across = Mat3::Zero();
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < images.size(); ++i) {
        const Ray ray = ray_of(rig.cameras[i], {images[i].x, images[i].y});
        const Mat3 plane = Mat3::Identity() - ray.along * ray.along.transpose();
        across += plane;
        moment += plane * ray.from;
    }
    return across.inverse() * moment;
}

/// What the found rig makes of true points, whose images have no noise.
struct PointError {
    double rms_mm = 0.0;  ///< after rigid alignment
    double scale = 0.0;   ///< share
};

PointError point_error(const Rig& found, const Rig& truth, double prism) {
    constexpr int count = 100;
    Rng rng(9, "points");
    MatX is(3, count);
    MatX should(3, count);
    for (int i = 0; i < count; ++i) {
        const Vec3 point = 50.0 * (2.0 * uniform3(rng) - Vec3::Ones());
        std::vector<cv::Point2d> images;
        for (const Camera& camera : truth.cameras) {
            images.push_back(seen_through_prism(camera, {point}, prism)[0]);
        }
        is.col(i) = crossing(found, images);
        should.col(i) = point;
    }
    const Eigen::Matrix4d motion = Eigen::umeyama(is, should, false);
    const MatX moved = (motion.topLeftCorner<3, 3>() * is).colwise() + Vec3(motion.topRightCorner<3, 1>());
    const Eigen::Matrix4d scaled = Eigen::umeyama(is, should, true);
    return {std::sqrt((moved - should).squaredNorm() / count),
            std::cbrt(scaled.topLeftCorner<3, 3>().determinant()) - 1.0};
}

const Wand three{{0.0, 80.0, 130.0}, 0.01};
const Wand two{{0.0, 130.0}, 0.01};

void print_found(const char* what, const WandCalibration& found, const Rig& truth, const PointError& points) {
    std::cout << what << ": residual " << found.residual_px << " px, cameras within "
              << 1e3 * place_error(found.rig, truth) << " um, points " << 1e3 * points.rms_mm << " um RMS, scale "
              << 100.0 * points.scale << " % (sigma " << 100.0 * found.scale_sigma << " %), camera 2 sigma "
              << 1e3 * found.cameras[1].position_sigma_mm << " um, " << found.frames_used << " frames used, "
              << found.frames_dropped << " dropped, " << found.iterations << " iterations, " << found.seconds << " s\n";
}

const int frames_of_test = rhexis::testing::sanitized ? 80 : 600;

}  // namespace

TEST_CASE("a wand of three spheres finds six cameras to micrometres, whatever their poses were thought to be") {
    const Rig truth = ring(6);
    Waving waving;
    waving.frames = frames_of_test;
    const std::vector<WandFrame> frames = waved(truth, three, waving);
    const Result<WandCalibration> found = calibrate_wand(guessed(truth, 50.0, 0.3), three, frames);
    REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
    const PointError points = point_error(found.value().rig, truth, waving.prism);
    print_found("three spheres", found.value(), truth, points);
    CHECK(found.value().rig.calibrated);
    CHECK(found.value().residual_px < 0.06);
    CHECK(found.value().residual_px > 0.03);
    CHECK(std::abs(points.scale) < 2e-4);
    CHECK(found.value().scale_sigma < 2e-4);
    if (!rhexis::testing::sanitized) {
        CHECK(place_error(found.value().rig, truth) < 0.04);
        CHECK(points.rms_mm < 0.005);
    }
}

TEST_CASE("a wand of two spheres, whose spots are not told apart, finds them from nominal poses") {
    const Rig truth = ring(6);
    Waving waving;
    waving.frames = frames_of_test;
    const Result<WandCalibration> found = calibrate_wand(guessed(truth, 45.0, 0.1), two, waved(truth, two, waving));
    REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
    const PointError points = point_error(found.value().rig, truth, waving.prism);
    print_found("two spheres", found.value(), truth, points);
    CHECK(found.value().residual_px < 0.06);
    CHECK(std::abs(points.scale) < 2e-4);
    CHECK(found.value().frames_dropped < found.value().frames_used / 50);
    if (!rhexis::testing::sanitized) {
        CHECK(points.rms_mm < 0.005);
    }
}

TEST_CASE("frames with a wrong spot are dropped and counted, and others are not") {
    const Rig truth = ring(6);
    Waving waving;
    waving.frames = rhexis::testing::sanitized ? 80 : 300;
    const Result<WandCalibration> clean = calibrate_wand(guessed(truth, 10.0, 0.03), two, waved(truth, two, waving));
    waving.outliers = 0.05;
    const Result<WandCalibration> spoilt = calibrate_wand(guessed(truth, 10.0, 0.03), two, waved(truth, two, waving));
    REQUIRE(clean.ok());
    REQUIRE_MESSAGE(spoilt.ok(), (spoilt ? "" : spoilt.error().text()));
    const PointError points = point_error(spoilt.value().rig, truth, waving.prism);
    print_found("5 % outliers", spoilt.value(), truth, points);
    CHECK(clean.value().frames_dropped <= 2);
    CHECK(spoilt.value().frames_dropped >= 2);
    CHECK(spoilt.value().frames_dropped < waving.frames / 10);
    CHECK(spoilt.value().residual_px < 0.06);
    CHECK(std::abs(points.scale) < 2e-4);
}

TEST_CASE("lenses that were slightly wrong are put right with the poses") {
    const Rig truth = ring(4);
    Waving waving;
    waving.frames = rhexis::testing::sanitized ? 80 : 300;
    const std::vector<WandFrame> frames = waved(truth, three, waving);
    Rig given = guessed(truth, 10.0, 0.03);
    for (Camera& camera : given.cameras) {
        camera.lens.fx *= 1.01;
        camera.lens.fy *= 1.01;
        camera.lens.k1 += 0.01;
    }
    WandSettings settings;
    const Result<WandCalibration> kept = calibrate_wand(given, three, frames, settings);
    settings.refine_lenses = true;
    const Result<WandCalibration> refined = calibrate_wand(given, three, frames, settings);
    REQUIRE(kept.ok());
    REQUIRE_MESSAGE(refined.ok(), (refined ? "" : refined.error().text()));
    print_found("refined lenses", refined.value(), truth, point_error(refined.value().rig, truth, waving.prism));
    CHECK(kept.value().residual_px > 0.1);
    CHECK(refined.value().residual_px < 0.06);
    for (const Camera& camera : refined.value().rig.cameras) {
        CHECK(std::abs(camera.lens.fx / 1667.0 - 1.0) < 5e-4);
    }
}

TEST_CASE("the rig keeps its builder's frame, or the first camera's pose") {
    const Rig truth = ring(3);
    Waving waving;
    waving.frames = 80;
    const std::vector<WandFrame> frames = waved(truth, three, waving);
    WandSettings settings;
    const Result<WandCalibration> nominal = calibrate_wand(truth, three, frames, settings);
    settings.frame = RigFrame::first_camera;
    const Result<WandCalibration> first = calibrate_wand(truth, three, frames, settings);
    REQUIRE(nominal.ok());
    REQUIRE(first.ok());
    CHECK((first.value().rig.cameras[0].pose.position - truth.cameras[0].pose.position).norm() < 1e-12);
    Vec3 moved = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        moved += nominal.value().rig.cameras[i].pose.position - truth.cameras[i].pose.position;
    }
    CHECK(moved.norm() < 1e-9);
}

TEST_CASE("a wand's length that was told wrongly makes the rig as much too large") {
    const Rig truth = ring(3);
    Waving waving;
    waving.frames = 80;
    waving.stretch = 1.01;
    const Result<WandCalibration> found = calibrate_wand(truth, three, waved(truth, three, waving));
    REQUIRE(found.ok());
    CHECK(point_error(found.value().rig, truth, waving.prism).scale == doctest::Approx(0.01).epsilon(0.05));
}

TEST_CASE("a wand that points at a camera is not taken the other way round, and no frame is lost by it") {
    const Rig truth = ring(6);
    const Wand long_one{{0.0, 80.0, 200.0}, 0.01};
    Waving waving;
    waving.frames = rhexis::testing::sanitized ? 80 : 150;
    const Result<WandCalibration> found =
        calibrate_wand(guessed(truth, 50.0, 0.3), long_one, waved(truth, long_one, waving));
    REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
    print_found("a long wand", found.value(), truth, point_error(found.value().rig, truth, waving.prism));
    CHECK(found.value().frames_dropped == 0);
    CHECK(found.value().frames_used > waving.frames * 9 / 10);
    CHECK(found.value().residual_px < 0.06);
    CHECK(found.value().iterations < 15);
}

TEST_CASE("a sphere's image is not about that of its centre, and the scale is right where that is known") {
    const Rig truth = ring(4);
    Waving waving;
    waving.frames = rhexis::testing::sanitized ? 80 : 150;
    waving.noise_px = 0.005;
    waving.radius_mm = 6.0;
    const std::vector<WandFrame> frames = waved(truth, three, waving);
    const auto scale_of = [&](double radius_mm) {
        Wand wand = three;
        wand.radius_mm = radius_mm;
        const Result<WandCalibration> found = calibrate_wand(truth, wand, frames);
        REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
        return point_error(found.value().rig, truth, waving.prism).scale;
    };
    const double of_points = scale_of(0.0);
    const double of_spheres = scale_of(waving.radius_mm);
    MESSAGE("scale ", of_points, " with points, ", of_spheres, " with spheres");
    CHECK(std::abs(of_points) > 1e-4);
    CHECK(std::abs(of_spheres) < 2e-5);
}

TEST_CASE("what is wrong with a wand calibration is told") {
    const Rig truth = ring(4);
    Waving waving;
    waving.frames = 80;
    const std::vector<WandFrame> frames = waved(truth, three, waving);
    const auto text_of = [&](const Wand& wand, const std::vector<WandFrame>& seen, const WandSettings& settings = {}) {
        const Result<WandCalibration> found = calibrate_wand(truth, wand, seen, settings);
        return found ? std::string("ok") : found.error().text();
    };
    CHECK(text_of(three, frames) == "ok");

    std::vector<WandFrame> blind = frames;
    for (WandFrame& frame : blind) {
        frame.views[2].spots.clear();
    }
    CHECK(text_of(three, blind).find("camera \"camera-3\" never sees the wand") != std::string::npos);

    std::vector<WandFrame> parted = frames;
    for (std::size_t i = 0; i < parted.size(); ++i) {
        for (std::size_t camera = 0; camera < 4; ++camera) {
            if ((camera < 2) == (i % 2 == 0)) {
                parted[i].views[camera].spots.clear();
            }
        }
    }
    CHECK(
        text_of(three, parted).find("cameras camera-1, camera-2 and cameras camera-3, camera-4 share too few frames") !=
        std::string::npos);

    const std::vector<WandFrame> few(frames.begin(), frames.begin() + 10);
    CHECK(text_of(three, few).find("only 10 frames") != std::string::npos);
    CHECK(text_of({{0.0, 80.0, 160.0}, 0.01}, frames).find("the gaps between") != std::string::npos);
    CHECK(text_of({{0.0, 80.0, 60.0}, 0.01}, frames).find("do not rise") != std::string::npos);
    CHECK(text_of({{0.0}, 0.01}, frames).find("a wand of 1 spheres") != std::string::npos);
    CHECK(text_of({{0.0, 3.0}, 0.01}, frames).find("length is 3") != std::string::npos);
    CHECK(text_of({{0.0, 130.0}, 0.0}, frames).find("sigma is 0") != std::string::npos);
    CHECK(text_of({{0.0, 130.0}, 0.01, -1.0}, frames).find("radius is -1") != std::string::npos);

    WandSettings hasty;
    hasty.most_iterations = 1;
    CHECK(text_of(three, frames, hasty).find("did not converge in 1 iterations") != std::string::npos);

    std::vector<WandFrame> foreign = frames;
    foreign[4].views[1].camera = 7;
    CHECK(text_of(three, foreign).find("frame 5: a view of camera 7") != std::string::npos);
    foreign[4].views[1].camera = 0;
    CHECK(text_of(three, foreign).find("two views of camera") != std::string::npos);
    foreign[4] = frames[4];
    foreign[4].views[0].spots[0].x() = std::nan("");
    CHECK(text_of(three, foreign).find("is not a number") != std::string::npos);
}

}  // namespace rhexis::tracking
