// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/calibrated_rig.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tracking/bodies/identity.hpp"
#include "tracking/bodies/rigid_fit.hpp"
#include "tracking/calibration/rig_calibration.hpp"
#include "tracking/calibration/rig_lenses.hpp"
#include "tracking/points/triangulation.hpp"
#include "tracking/sources/board_source.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

const GridPlan board{9, 7, 15.0, GridKind::dots};

/// What each camera sees of the board.
Result<std::vector<SeenBoards>> boards_of(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan) {
    if (plan.board_images) {
        const Result<std::unique_ptr<FrameSource>> source = film_boards(rig, board, plan.boards, plan.seed);
        return source ? look_for_boards(*source.value(), rig.nominal, {board, plan.boards}, [](double) {})
                      : source.error();
    }
    std::vector<SeenBoards> seen;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        seen.push_back({held_board(rig.cameras[i], board, plan.boards, plan.board_sigma_px, plan.seed * 100U + i)});
    }
    return seen;
}

Status find_lenses_by_boards(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan, Rig& solver,
                             SyntheticCalibration& result) {
    Result<std::vector<SeenBoards>> seen = boards_of(rig, plan);
    if (!seen) {
        return seen.error();
    }
    Result<RigLenses> lenses = calibrate_lenses(solver, std::move(seen).value(), {board, plan.boards});
    if (!lenses) {
        return lenses.error();
    }
    solver = std::move(lenses.value().rig);
    for (const LensFigures& figures : solver.lenses) {
        result.board_residual_px = std::max(result.board_residual_px, figures.residual_px);
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
        frames.push_back(wand_frame(exposures, synthetic::wand_mm.size()));
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
    if (const Status status = find_lenses_by_boards(rig, plan, given, result); !status) {
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
    wand.radius_mm = synthetic::Sphere{}.radius;
    WandSettings settings;
    settings.refine_lenses = true;
    const Result<WandCalibration> found = calibrate_wand(given, wand, frames.value(), settings);
    if (!found) {
        return found.error();
    }
    result.rig = found.value().rig;
    result.wand_residual_px = found.value().residual_px;
    result.scale_sigma = found.value().scale_sigma;
    result.seconds = found.value().seconds;
    result.iterations = found.value().iterations;
    compare_with_truth(rig, result);
    return result;
}

}  // namespace rhexis::tracking
