// SPDX-License-Identifier: GPL-3.0-or-later
// Lenses from images of a board: rendered by cameras with thin-prism terms, of which no solver knows.
#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/index.hpp"
#include "support/sanitized.hpp"
#include "tracking/calibration/board_finder.hpp"
#include "tracking/calibration/dot_image.hpp"
#include "tracking/calibration/rig_lenses.hpp"
#include "tracking/measure/calibrated_rig.hpp"
#include "tracking/measure/tip_errors.hpp"
#include "tracking/sources/board_source.hpp"
#include "tracking/synthetic/bodies.hpp"

namespace rhexis::tracking {
namespace {

const GridPlan small_dots{9, 7, 18.0, GridKind::dots};
const GridPlan small_chess{8, 6, 20.0, GridKind::chess};

/// Cameras of a quarter of the pixels.
synthetic::SyntheticRig rig_of_boards(int cameras) {
    synthetic::RigOptions options;
    options.cameras = cameras;
    options.width = 640;
    options.height = 512;
    options.focal_px = 833.0;
    return synthetic::SyntheticRig::create(5, options).value();
}

/// Distances of found points from those that the true camera sees, whichever of the four ways the board was taken.
double rms_from(const BoardView& view, const synthetic::TrueCamera& camera, const GridPlan& plan, const Pose& pose) {
    double squares = 0.0;
    for (const Vec2& point : view.points) {
        double nearest = 1e9;
        for (int i = 0; i < plan.points(); ++i) {
            const Vec2 on_board = point_of(plan, i);
            const Vec3 seen = pose.to_world({on_board.x(), on_board.y(), 0.0});
            nearest = std::min(nearest, (point - distorted(camera.lens, seen.head<2>() / seen.z())).squaredNorm());
        }
        squares += 0.5 * nearest;
    }
    return std::sqrt(squares / static_cast<double>(view.points.size()));
}

/// Of points found in some views of one camera [pixels each way].
double found_rms(const GridPlan& plan, int views) {
    const synthetic::SyntheticRig rig = rig_of_boards(2);
    const std::vector<Pose> poses = synthetic::held_poses(rig.cameras[0], plan, views, 500);
    const auto source = film_boards(rig, plan, views, 5).value();
    FrameSet set;
    double squares = 0.0;
    for (const Pose& pose : poses) {
        REQUIRE(source->next(set).value());
        const std::optional<BoardView> view = find_board(set.frames[0].view(), plan, "view");
        REQUIRE(view.has_value());
        const double rms = rms_from(*view, rig.cameras[0], plan, pose);
        squares += rms * rms;
    }
    return std::sqrt(squares / views);
}

/// Images that were taken before, with a dark one after each, and each twice.
class StutteringSource final : public FrameSource {
public:
    explicit StutteringSource(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

    Result<bool> next(FrameSet& set) override {
        const int step = count_++ % 3;
        if (step == 0 && !source_->next(kept_).value()) {
            return false;
        }
        set = kept_;
        for (CameraFrame& frame : set.frames) {
            frame.from = "shot " + std::to_string(count_);
            if (step == 2) {
                std::fill(frame.pixels.begin(), frame.pixels.end(), std::uint8_t{7});
            }
        }
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return source_->rate_hz(); }

private:
    std::unique_ptr<FrameSource> source_;
    FrameSet kept_{};
    int count_ = 0;
};

std::string board_error(std::string_view text) {
    const Result<GridPlan> plan = parse_board(text);
    return plan ? std::string("ok") : plan.error().text();
}

}  // namespace

TEST_CASE("a board is told in a word, and what is none is refused with how it is told") {
    const GridPlan plan = parse_board("dots:13x9x14.5").value();
    CHECK(plan.columns == 13);
    CHECK(plan.rows == 9);
    CHECK(plan.spacing_mm == 14.5);
    CHECK(plan.kind == GridKind::dots);
    CHECK(parse_board("chess:10x7x20").value().kind == GridKind::chess);
    CHECK(point_of(plan, 0) == Vec2(-87.0, -58.0));
    CHECK(point_of(plan, 13 * 4 + 6) == Vec2(0.0, 0.0));
    for (const char* wrong : {"", "dots", "dots:", "dots:13x9", "dots:13x9x", "dots:13x9x14x2", "stars:13x9x14",
                              "dots:13.5x9x14", "dots: 13x9x14", "dots:13x9x14mm"}) {
        CHECK_MESSAGE(board_error(wrong).find("is no board (dots:COLUMNSxROWSxMM") != std::string::npos, wrong);
    }
    CHECK(board_error("dots:2x9x14").find("columns is 2") != std::string::npos);
    CHECK(board_error("chess:13x9x0").find("spacing is 0") != std::string::npos);
    CHECK(board_error("chess:13x9xnan").find("spacing is nan") != std::string::npos);
}

TEST_CASE("the middle of a slanted dot's image is where its rim has it, and its area tells its radius") {
    const Lens lens{1667.0, 1667.0, 640.0, 512.0, 0, 0, 0, 0, 0};
    const Pose board{{60.0, -40.0, 380.0}, Quat(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 0.3).normalized()))};
    const Vec2 on_board(30.0, 20.0);
    constexpr double radius = 4.0;
    Eigen::AlignedBox2d box;
    double area = 0.0;
    Vec2 before = Vec2::Zero();
    constexpr int count = 20000;
    for (int i = 0; i <= count; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / count;
        const Vec2 rim = on_board + radius * Vec2(std::cos(turn), std::sin(turn));
        const Vec3 seen = board.to_world({rim.x(), rim.y(), 0.0});
        const Vec2 at = distorted(lens, seen.head<2>() / seen.z());
        area += i == 0 ? 0.0 : 0.5 * (before.x() * at.y() - before.y() * at.x());
        before = at;
        box.extend(at);
    }
    const Vec3 centre = board.to_world({on_board.x(), on_board.y(), 0.0});
    const Vec2 off = box.center() - distorted(lens, centre.head<2>() / centre.z());
    CHECK(off.norm() > 0.03);
    CHECK((dot_off(lens, board, on_board, radius) - off).norm() < 1e-4);
    CHECK(dot_radius(lens, board, on_board, std::abs(area)) == doctest::Approx(radius).epsilon(1e-3));
}

TEST_CASE("dots and corners are found in images to a few hundredths of a pixel") {
    const int views = rhexis::testing::sanitized ? 1 : 4;
    const double dots = found_rms(small_dots, views);
    const double corners = found_rms(small_chess, views);
    MESSAGE("dots ", dots, " px, corners ", corners, " px, each way");
    CHECK(dots < 0.05);
    CHECK(corners < 0.1);
}

TEST_CASE("images without a board, and those in which nothing moved, are counted and named") {
    const synthetic::SyntheticRig rig = rig_of_boards(2);
    BoardsPlan plan{small_dots, 3};
    StutteringSource source(film_boards(rig, small_dots, 4, 5).value());
    double done = 0.0;
    const std::vector<SeenBoards> seen =
        look_for_boards(source, rig.nominal, plan, [&done](double share) { done = share; }).value();
    REQUIRE(seen.size() == 2);
    CHECK(done == 1.0);
    for (const SeenBoards& camera : seen) {
        CHECK(camera.views.size() == 3);
        CHECK(camera.alike == 2);
        CHECK(camera.without == std::vector<std::string>{"shot 3", "shot 6"});
        CHECK(camera.views[1].name == "shot 4");
    }
}

TEST_CASE("a camera that never saw a board is named, and so is one whose views are too few") {
    const synthetic::SyntheticRig rig = rig_of_boards(2);
    const BoardsPlan plan{small_dots, 10};
    std::vector<SeenBoards> seen(2);
    seen[0].without = {"1.png", "2.png"};
    seen[1].views = held_board(rig.cameras[1], small_dots, 10, 0.02, 1);
    const auto error_of = [&] {
        const Result<RigLenses> found = calibrate_lenses(rig.nominal, seen, plan);
        return found ? std::string("ok") : found.error().text();
    };
    CHECK(error_of().find("camera \"camera1\": no board of 9 x 7 dots in any of 2 images") != std::string::npos);
    seen[0].views = held_board(rig.cameras[0], small_dots, 5, 0.02, 2);
    CHECK(error_of().find("camera \"camera1\", lens: only 5 views of the board") != std::string::npos);
    seen[0].views = held_board(rig.cameras[0], small_dots, 10, 0.02, 2);
    seen[0].views[4].width = 320;
    CHECK(error_of().find("the image is 320 x 512 pixels") != std::string::npos);
    seen[0].views[4].width = 640;
    CHECK(error_of() == "ok");
}

TEST_CASE("a rig's file keeps how its lenses were found, and what is wrong there is named") {
    const std::string path =
        (std::filesystem::temp_directory_path() / ("rhexis_rig_" + std::to_string(::getpid()) + ".json")).string();
    Rig rig = rig_of_boards(2).nominal;
    Coverage coverage;
    coverage.points.assign(at(coverage.columns * coverage.rows), 3);
    coverage.points[5] = 0;
    rig.lenses.assign(2, {24, 1, 3, 0.04, 0.6, coverage});
    REQUIRE(write_rig(rig, path).ok());
    const Rig read = read_rig(path).value();
    REQUIRE(read.lenses.size() == 2);
    CHECK(read.lenses[1].views == 24);
    CHECK(read.lenses[1].without == 3);
    CHECK(read.lenses[1].residual_px == 0.04);
    CHECK(read.lenses[1].coverage.points == coverage.points);
    rig.lenses[1].coverage.points.pop_back();
    REQUIRE(write_rig(rig, path).ok());
    CHECK(read_rig(path).error().text().find("camera 2, \"lens\"") != std::string::npos);
    rig.lenses.clear();
    REQUIRE(write_rig(rig, path).ok());
    CHECK(read_rig(path).value().lenses.empty());
    std::filesystem::remove(path);
}

TEST_CASE("a board that is too large for a camera is refused, and the camera named") {
    const auto source = film_boards(rig_of_boards(2), {13, 9, 60.0, GridKind::dots}, 3, 5);
    REQUIRE_FALSE(source.ok());
    CHECK(source.error().text().find("the board does not fit into the image of \"camera1\"") != std::string::npos);
}

TEST_CASE("a rig whose lenses are from images of boards is as good as one of points with noise" *
          doctest::skip(rhexis::testing::sanitized)) {
    const synthetic::SyntheticRig rig = rig_of_boards(4);
    CalibrationPlan plan;
    plan.seed = 5;
    plan.boards = 12;
    plan.wand_frames = 150;
    const auto tip_of = [&rig, &plan](const char* what) {
        const SyntheticCalibration made = calibrate_synthetic(rig, plan).value();
        const synthetic::Clip clip =
            synthetic::make_clip("circle", 5, synthetic::standard_bodies(), rig.nominal).value();
        ClipPlan clip_plan;
        clip_plan.seed = 5;
        clip_plan.images = false;
        clip_plan.longest_s = 0.5;
        const ClipRun run = track_clip(rig, made.rig, clip, clip_plan).value();
        const double tip_mm = tip_errors(run.traces[1]).mean;
        MESSAGE(std::string(what), ": boards ", made.board_residual_px, " px, wand ", made.wand_residual_px,
                " px, scale ", made.scale_error, ", tip ", 1e3 * tip_mm, " um");
        CHECK(made.wand_residual_px < 0.05);
        CHECK(std::abs(made.scale_error) < 1e-4);
        return tip_mm;
    };
    const double of_points = tip_of("points with noise");
    plan.board_images = true;
    const double of_images = tip_of("images of dots");
    CHECK(of_images < 1.3 * of_points);
}

}  // namespace rhexis::tracking
