// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/rig_lenses.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "tracking/calibration/board_finder.hpp"

namespace rhexis::tracking {
namespace {

double mean_move(const std::vector<Vec2>& points, const std::vector<Vec2>& others, bool from_behind) {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += (points[i] - others[from_behind ? points.size() - 1 - i : i]).norm();
    }
    return sum / static_cast<double>(points.size());
}

/// Whether a board has moved since; it may have been found the other way round.
bool has_moved(const BoardView& view, const BoardView& before, double least_px) {
    return std::min(mean_move(view.points, before.points, false), mean_move(view.points, before.points, true)) >=
           least_px;
}

std::string name_of(const CameraFrame& frame, const Rig& rig, int number) {
    return frame.from.empty() ? rig.cameras[rhexis::at(frame.camera)].name + ", image " + std::to_string(number)
                              : frame.from;
}

void look_at(const CameraFrame& frame, const std::string& name, const BoardsPlan& plan, SeenBoards& seen) {
    std::optional<BoardView> view = find_board(frame.view(), plan.board, name);
    if (!view) {
        seen.without.push_back(name);
    } else if (!seen.views.empty() && !has_moved(*view, seen.views.back(), plan.least_move_px)) {
        ++seen.alike;
    } else {
        seen.views.push_back(std::move(*view));
    }
}

std::size_t fewest_views_of(const std::vector<SeenBoards>& seen) {
    std::size_t fewest = seen.front().views.size();
    for (const SeenBoards& one : seen) {
        fewest = std::min(fewest, one.views.size());
    }
    return fewest;
}

const char* points_of_kind(GridKind kind) { return kind == GridKind::dots ? "dots" : "inner corners"; }

Error never_found(const std::string& camera, const SeenBoards& seen, const GridPlan& board) {
    return {"no board of " + std::to_string(board.columns) + " x " + std::to_string(board.rows) + " " +
                points_of_kind(board.kind) + " in any of " + std::to_string(seen.without.size()) + " images",
            "camera \"" + camera + "\"", "all of it in the image, not cut off, and sharp"};
}

LensFigures figures_of_lens(const SeenBoards& seen, const LensCalibration& lens) {
    const auto used =
        std::count_if(lens.views.begin(), lens.views.end(), [](const BoardFit& view) { return view.used; });
    LensFigures figures;
    figures.views = static_cast<int>(used);
    figures.left_out = static_cast<int>(lens.views.size()) - figures.views;
    figures.without = static_cast<int>(seen.without.size());
    figures.residual_px = lens.residual_px;
    figures.focal_sigma_px = lens.focal_sigma_px;
    figures.coverage = lens.coverage;
    return figures;
}

}  // namespace

Result<std::vector<SeenBoards>> look_for_boards(FrameSource& source, const Rig& rig, const BoardsPlan& plan,
                                                const std::function<void(double)>& progress) {
    std::vector<SeenBoards> seen(rig.cameras.size());
    const auto enough = rhexis::at(plan.views);
    std::optional<double> begun_s;
    FrameSet set;
    for (int number = 1; fewest_views_of(seen) < enough; ++number) {
        const Result<bool> more = source.next(set);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            break;
        }
        begun_s = begun_s.value_or(set.time_s);
        if (set.time_s - *begun_s > plan.seconds) {
            break;
        }
        for (const CameraFrame& frame : set.frames) {
            SeenBoards& one = seen[rhexis::at(frame.camera)];
            if (one.views.size() < enough) {
                look_at(frame, name_of(frame, rig, number), plan, one);
            }
        }
        progress(static_cast<double>(fewest_views_of(seen)) / plan.views);
    }
    return seen;
}

Result<RigLenses> calibrate_lenses(const Rig& given, std::vector<SeenBoards> seen, const BoardsPlan& plan) {
    RigLenses result{given, std::move(seen), {}};
    result.rig.calibrated = false;
    result.rig.lenses.clear();
    for (std::size_t i = 0; i < given.cameras.size(); ++i) {
        const SeenBoards& one = result.seen[i];
        if (one.views.empty()) {
            return never_found(given.cameras[i].name, one, plan.board);
        }
        Result<LensCalibration> lens = calibrate_lens(one.views, plan.board, plan.lens);
        if (!lens) {
            Error error = lens.error();
            error.where = "camera \"" + given.cameras[i].name + "\", " + error.where;
            return error;
        }
        result.rig.cameras[i].lens = lens.value().lens;
        result.rig.lenses.push_back(figures_of_lens(one, lens.value()));
        result.calibrations.push_back(std::move(lens).value());
    }
    return result;
}

}  // namespace rhexis::tracking
