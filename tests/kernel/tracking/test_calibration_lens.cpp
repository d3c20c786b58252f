// SPDX-License-Identifier: GPL-3.0-or-later
// Boards held before a lens that is known, with thin prism terms that the calibration knows nothing of.
#include <doctest/doctest.h>

#include <iostream>
#include <opencv2/calib3d.hpp>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "support/sanitized.hpp"
#include "tracking/calibration/board_finder.hpp"
#include "tracking/calibration/lens_calibration.hpp"

namespace rhexis::tracking {
namespace {

const Lens true_lens{1667.0, 1668.5, 642.0, 509.0, -0.11, 0.07, 3e-4, -2e-4, 0.01};
const GridPlan board{9, 7, 15.0, GridKind::dots};

/// A board turned about x and y, its middle at a place of the camera's frame.
std::vector<cv::Point2d> board_image(double about_x, double about_y, const Vec3& middle) {
    std::vector<cv::Point3d> points;
    const Quat turn = Quat(Eigen::AngleAxisd(about_x, Vec3::UnitX())) * Quat(Eigen::AngleAxisd(about_y, Vec3::UnitY()));
    for (int row = 0; row < board.rows; ++row) {
        for (int column = 0; column < board.columns; ++column) {
            const Vec3 flat(board.spacing_mm * (column - 0.5 * (board.columns - 1)),
                            board.spacing_mm * (row - 0.5 * (board.rows - 1)), 0.0);
            const Vec3 at = turn * flat + middle;
            points.emplace_back(at.x(), at.y(), at.z());
        }
    }
    const Lens& lens = true_lens;
    const std::vector<double> bends{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, 0, 0, 0, 5e-5, 0, -5e-5, 0};
    std::vector<cv::Point2d> images;
    cv::projectPoints(points, cv::Vec3d(0, 0, 0), cv::Vec3d(0, 0, 0),
                      cv::Matx33d(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1), bends, images);
    return images;
}

/// Boards all over the image; `slant` is the greatest turn [radians], `reach` how far they come to the rims.
std::vector<BoardView> boards(int count, double slant, double reach = 1.0) {
    Rng rng(2, "boards");
    std::vector<BoardView> views;
    for (int i = 0; i < count; ++i) {
        const double depth = 380.0 + 80.0 * rng.uniform();
        const Vec3 middle(reach * 70.0 * (i % 3 - 1), reach * 55.0 * (i / 3 % 3 - 1), depth);
        const double about_x = slant * (2.0 * rng.uniform() - 1.0);
        const double about_y = slant * (2.0 * rng.uniform() - 1.0);
        BoardView view{"view " + std::to_string(i + 1), 1280, 1024, {}};
        for (const cv::Point2d& at : board_image(about_x, about_y, middle)) {
            const Vec2 noise = 0.05 * normal2(rng);
            view.points.emplace_back(at.x + noise.x(), at.y + noise.y());
        }
        views.push_back(std::move(view));
    }
    return views;
}

std::string lens_error(const std::vector<BoardView>& views, const GridPlan& plan = board) {
    const Result<LensCalibration> found = calibrate_lens(views, plan);
    return found ? std::string("ok") : found.error().text();
}

/// Greatest distance, inside the image, between what two lenses make of a direction, the focal length's share apart.
double image_difference(const Lens& one, const Lens& other) {
    double most = 0.0;
    for (double x = -0.36; x <= 0.36; x += 0.09) {
        for (double y = -0.28; y <= 0.28; y += 0.07) {
            most = std::max(most, (distorted(one, {x, y}) - distorted(other, {x, y})).norm());
        }
    }
    return most;
}

}  // namespace

TEST_CASE("a lens is found from slanted boards, with a residual as great as the noise") {
    const std::vector<BoardView> views = boards(rhexis::testing::sanitized ? 12 : 27, 0.5);
    const Result<LensCalibration> found = calibrate_lens(views, board);
    REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
    const LensCalibration& lens = found.value();
    std::cout << "lens: residual " << lens.residual_px << " px, fx " << lens.lens.fx << " (sigma "
              << lens.focal_sigma_px << "), images differ by up to " << image_difference(lens.lens, true_lens)
              << " px, coverage " << lens.coverage.share() << "\n";
    CHECK(lens.residual_px == doctest::Approx(0.05 * std::sqrt(2.0)).epsilon(0.1));
    CHECK(std::abs(lens.lens.fx - true_lens.fx) < 4.0 * lens.focal_sigma_px);
    CHECK(lens.focal_sigma_px < (rhexis::testing::sanitized ? 2.5 : 1.0));
    CHECK(image_difference(lens.lens, true_lens) < 1.5);
    CHECK(lens.coverage.share() > 0.9);
    for (const BoardFit& view : lens.views) {
        CHECK(view.used);
    }
}

TEST_CASE("a view that is spoilt is left out, and it alone") {
    std::vector<BoardView> views = boards(15, 0.5);
    Rng rng(4);
    for (Vec2& point : views[5].points) {
        point += 2.0 * normal2(rng);
    }
    const Result<LensCalibration> found = calibrate_lens(views, board);
    REQUIRE_MESSAGE(found.ok(), (found ? "" : found.error().text()));
    for (std::size_t i = 0; i < views.size(); ++i) {
        CHECK(found.value().views[i].used == (i != 5));
    }
    CHECK(found.value().views[5].residual_px > 1.0);
    CHECK(found.value().residual_px < 0.09);
}

TEST_CASE("boards that do not determine a lens are refused with what is missing") {
    CHECK(lens_error(boards(12, 0.5)) == "ok");
    CHECK(lens_error(boards(5, 0.5)).find("only 5 views of the board (at least 8)") != std::string::npos);
    CHECK(lens_error(boards(12, 0.02)).find("the focal length is not determined") != std::string::npos);
    CHECK(lens_error(boards(12, 0.5, 0.1)).find("show the board in every corner") != std::string::npos);
}

TEST_CASE("views that are not of one camera and one board are refused and named") {
    std::vector<BoardView> views = boards(12, 0.5);
    views[3].width = 640;
    CHECK(lens_error(views).find("view 4: the image is 640 x 1024 pixels") != std::string::npos);
    views[3].width = 1280;
    views[7].points.pop_back();
    CHECK(lens_error(views).find("view 8: 62 points") != std::string::npos);
    CHECK(lens_error(boards(12, 0.5), {1, 63, 15.0, GridKind::dots}).find("columns is 1") != std::string::npos);
    std::vector<BoardView> points(12, BoardView{"all at one place", 1280, 1024, std::vector<Vec2>(63, Vec2(5, 5))});
    CHECK(lens_error(points) != "ok");
}

TEST_CASE("a board is found in an image of it, and none where there is none") {
    std::vector<std::uint8_t> pixels(1280 * 1024, 230);
    const std::vector<cv::Point2d> truth = board_image(0.2, 0.3, {0, 0, 400});
    for (const cv::Point2d& at : truth) {
        for (int y = -14; y <= 14; ++y) {
            for (int x = -14; x <= 14; ++x) {
                const int column = static_cast<int>(std::lround(at.x)) + x;
                const int row = static_cast<int>(std::lround(at.y)) + y;
                const double off = std::hypot(column - at.x, row - at.y);
                if (column >= 0 && row >= 0 && column < 1280 && row < 1024 && off < 13.0) {
                    const double light = std::clamp(off - 11.5, 0.0, 1.0);
                    pixels[static_cast<std::size_t>(row) * 1280 + static_cast<std::size_t>(column)] =
                        static_cast<std::uint8_t>(30.0 + 200.0 * light);
                }
            }
        }
    }
    const GreyImage image{pixels.data(), 1280, 1024, 1280};
    const std::optional<BoardView> found = find_board(image, board, "image");
    REQUIRE(found.has_value());
    REQUIRE(found->points.size() == truth.size());
    for (const cv::Point2d& at : truth) {
        double nearest = 1e9;
        for (const Vec2& point : found->points) {
            nearest = std::min(nearest, (point - Vec2(at.x, at.y)).norm());
        }
        CHECK(nearest < 0.3);
    }
    const std::vector<std::uint8_t> empty(1280 * 1024, 230);
    CHECK_FALSE(find_board({empty.data(), 1280, 1024, 1280}, board, "nothing").has_value());
    CHECK_FALSE(find_board({empty.data(), 1280, 1024, 1280}, {9, 7, 15.0, GridKind::chess}, "nothing").has_value());
}

}  // namespace rhexis::tracking
