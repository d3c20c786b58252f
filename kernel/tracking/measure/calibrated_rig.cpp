// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/calibrated_rig.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/rng.hpp"
#include "tracking/bodies/identity.hpp"
#include "tracking/bodies/rigid_fit.hpp"
#include "tracking/calibration/lens_calibration.hpp"
#include "tracking/points/triangulation.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

const GridPlan board{9, 7, 15.0, GridKind::dots};

/// A board held slanted before a camera, its middle in one of nine parts of the image by turns.
BoardView board_view(const synthetic::TrueCamera& camera, int number, double sigma_px, Rng& rng) {
    constexpr double slant = 0.5;
    const double depth = 380.0 + 80.0 * rng.uniform();
    const Vec3 middle(70.0 * (number % 3 - 1), 55.0 * (number / 3 % 3 - 1), depth);
    const Quat turn = Quat(Eigen::AngleAxisd(slant * (2.0 * rng.uniform() - 1.0), Vec3::UnitX())) *
                      Quat(Eigen::AngleAxisd(slant * (2.0 * rng.uniform() - 1.0), Vec3::UnitY()));
    BoardView view{camera.name + " board " + std::to_string(number + 1), camera.width, camera.height, {}};
    for (int row = 0; row < board.rows; ++row) {
        for (int column = 0; column < board.columns; ++column) {
            const Vec3 flat(board.spacing_mm * (column - 0.5 * (board.columns - 1)),
                            board.spacing_mm * (row - 0.5 * (board.rows - 1)), 0.0);
            const Vec3 at = turn * flat + middle;
            const Vec2 image = distorted(camera.lens, at.head<2>() / at.z());
            view.points.push_back(image + sigma_px * Vec2(rng.normal(), rng.normal()));
        }
    }
    return view;
}

Status calibrate_lenses(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan, Rig& solver,
                        SyntheticCalibration& result) {
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        Rng rng(plan.seed, "boards " + std::to_string(i));
        std::vector<BoardView> views;
        for (int number = 0; number < plan.boards; ++number) {
            views.push_back(board_view(rig.cameras[i], number, plan.board_sigma_px, rng));
        }
        const Result<LensCalibration> lens = calibrate_lens(views, board);
        if (!lens) {
            return lens.error();
        }
        solver.cameras[i].lens = lens.value().lens;
        result.board_residual_px = std::max(result.board_residual_px, lens.value().residual_px);
    }
    return success();
}

Result<std::unique_ptr<SpotSource>> wand_source(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan) {
    synthetic::Film film;
    film.frames = plan.wand_frames;
    film.seed = plan.seed + 7919;
    film.delivery.rate_hz = plan.wand_rate_hz;
    const synthetic::Stage stage = synthetic::waved_wand(plan.seed);
    if (!plan.images) {
        return film_markers(rig, stage, film);
    }
    Result<std::unique_ptr<FrameSource>> frames = film_images(rig, stage, film);
    if (!frames) {
        return frames.error();
    }
    return std::unique_ptr<SpotSource>(std::make_unique<ImageSpots>(std::move(frames).value(), SpotSettings{}));
}

/// Views of a wand of which all spheres are whole: what a person's program would take.
void add_view(const CameraSpots& exposure, WandFrame& frame) {
    constexpr double least_roundness = 0.9;
    std::vector<Vec2> spots;
    for (const Spot& spot : exposure.spots) {
        if (!spot.at_rim && !spot.crowded && spot.roundness > least_roundness) {
            spots.push_back(spot.at);
        }
    }
    if (spots.size() == synthetic::wand_mm.size()) {
        frame.views.push_back({exposure.camera, spots});
    }
}

Result<std::vector<WandFrame>> wand_frames(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan) {
    Result<std::unique_ptr<SpotSource>> source = wand_source(rig, plan);
    if (!source) {
        return source.error();
    }
    std::vector<WandFrame> frames;
    std::vector<CameraSpots> exposures;
    for (;;) {
        const Result<bool> more = source.value()->next(exposures);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return frames;
        }
        WandFrame frame;
        for (const CameraSpots& exposure : exposures) {
            add_view(exposure, frame);
        }
        frames.push_back(std::move(frame));
    }
}

/// Where a solver has a point that the true cameras see, from all of them; none: not two do.
std::optional<Vec3> solved_point(const synthetic::SyntheticRig& rig, const Rig& solver, const Vec3& point) {
    std::vector<View> views;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        if (const std::optional<Vec2> image = project(rig.cameras[i], point)) {
            views.push_back({static_cast<int>(i), 0, *image});
        }
    }
    const std::optional<Triangulated> found = triangulate(solver.cameras, views);
    return found ? std::optional<Vec3>(found->point) : std::nullopt;
}

/// Of a lattice of 5 x 5 x 5 points, 120 mm wide, about the eye.
void compare_with_truth(const synthetic::SyntheticRig& rig, SyntheticCalibration& result) {
    std::vector<Vec3> true_points;
    std::vector<Vec3> points;
    for (int i = 0; i < 125; ++i) {
        const Vec3 at = 30.0 * Vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
        if (const std::optional<Vec3> solved = solved_point(rig, result.rig, at)) {
            true_points.push_back(at);
            points.push_back(*solved);
        }
    }
    const Pose rigid = fitted(true_points, points);
    double along = 0.0;
    double spread = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 arm = rigid.orientation * true_points[i];
        along += arm.dot(points[i] - rigid.position);
        spread += arm.squaredNorm();
        squares += (rigid.to_world(true_points[i]) - points[i]).squaredNorm();
    }
    result.scale_error = along / spread - 1.0;
    result.bend_mm = std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace

Result<SyntheticCalibration> calibrate_synthetic(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan) {
    SyntheticCalibration result;
    Rig given = rig.nominal;
    if (const Status status = calibrate_lenses(rig, plan, given, result); !status) {
        return status.error();
    }
    const Result<std::vector<WandFrame>> frames = wand_frames(rig, plan);
    if (!frames) {
        return frames.error();
    }
    Wand wand;
    for (const double at : synthetic::wand_mm) {
        wand.at_mm.push_back(at * (1.0 - plan.wand_error_mm / synthetic::wand_mm.back()));
    }
    WandSettings settings;
    settings.refine_lenses = true;
    settings.most_iterations = 200;  // some rigs take more than 50, lenses and poses being so much alike
    const Result<WandCalibration> found = calibrate_wand(given, wand, frames.value(), settings);
    if (!found) {
        return found.error();
    }
    result.rig = found.value().rig;
    result.wand_residual_px = found.value().residual_px;
    result.scale_sigma = found.value().scale_sigma;
    result.seconds = found.value().seconds;
    compare_with_truth(rig, result);
    return result;
}

}  // namespace rhexis::tracking
