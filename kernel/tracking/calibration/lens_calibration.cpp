// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/lens_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/calib3d.hpp>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "math/blas.hpp"
#include "tracking/calibration/dot_image.hpp"

namespace rhexis::tracking {
namespace {

constexpr int smallest_side = 16;  ///< of an image [pixels]

std::vector<cv::Point2f> pixels_of(const BoardView& view) {
    std::vector<cv::Point2f> pixels;
    for (const Vec2& point : view.points) {
        pixels.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    }
    return pixels;
}

std::vector<cv::Point3f> points_of(const GridPlan& plan) {
    std::vector<cv::Point3f> points;
    for (int i = 0; i < plan.points(); ++i) {
        const Vec2 at = point_of(plan, i);
        points.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F);
    }
    return points;
}

Status check_view(const BoardView& view, const BoardView& first, const GridPlan& plan) {
    if (view.width != first.width || view.height != first.height) {
        return Error{"the image is " + std::to_string(view.width) + " x " + std::to_string(view.height) + " pixels",
                     view.name,
                     std::to_string(first.width) + " x " + std::to_string(first.height) + " as " + first.name};
    }
    if (view.points.size() != rhexis::at(plan.points())) {
        return Error{std::to_string(view.points.size()) + " points", view.name,
                     std::to_string(plan.points()) + ", as the board has"};
    }
    if (!std::all_of(view.points.begin(), view.points.end(), [](const Vec2& point) { return point.allFinite(); })) {
        return Error{"a point is not a number", view.name, "pixels"};
    }
    return success();
}

Status check_views(std::span<const BoardView> views, const GridPlan& plan, int fewest) {
    if (views.size() < static_cast<std::size_t>(std::max(3, fewest))) {
        return Error{"only " + std::to_string(views.size()) + " views of the board", "lens",
                     "at least " + std::to_string(std::max(3, fewest))};
    }
    if (views.front().width < smallest_side || views.front().height < smallest_side) {
        return Error{"the image has no size", views.front().name, "at least 16 x 16 pixels"};
    }
    for (const BoardView& view : views) {
        if (const Status status = check_view(view, views.front(), plan); !status) {
            return status;
        }
    }
    return success();
}

/// Difference in depth between a board's nearest and farthest corner, as a share: what its homography divides by.
double slant_of(const BoardView& view, const GridPlan& plan) {
    std::vector<cv::Point2d> flat;
    std::vector<cv::Point2d> seen;
    for (std::size_t i = 0; i < view.points.size(); ++i) {
        const int index = static_cast<int>(i);
        flat.emplace_back(index % plan.columns, index / plan.columns);
        seen.emplace_back(view.points[i].x(), view.points[i].y());
    }
    const cv::Mat map = cv::findHomography(flat, seen);
    if (map.rows != 3) {
        return 0.0;
    }
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -nearest;
    for (const double x : {0.0, plan.columns - 1.0}) {
        for (const double y : {0.0, plan.rows - 1.0}) {
            const double depth = map.at<double>(2, 0) * x + map.at<double>(2, 1) * y + map.at<double>(2, 2);
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    }
    return (farthest - nearest) / (0.5 * std::abs(farthest + nearest));
}

Status check_slants(std::span<const BoardView> views, const GridPlan& plan, const LensSettings& settings) {
    const auto slanted = std::count_if(views.begin(), views.end(), [&](const BoardView& view) {
        return slant_of(view, plan) >= settings.least_slant;
    });
    if (slanted < settings.fewest_slanted) {
        return Error{"only " + std::to_string(slanted) + " views are slanted, so the focal length is not determined",
                     "lens",
                     "at least " + std::to_string(settings.fewest_slanted) +
                         " with the board turned by 20 degrees or more, to different sides"};
    }
    return success();
}

Coverage coverage_of_views(std::span<const BoardView> views) {
    std::vector<Vec2> all;
    for (const BoardView& view : views) {
        all.insert(all.end(), view.points.begin(), view.points.end());
    }
    return coverage_of(all, views.front().width, views.front().height);
}

Status check_coverage(const Coverage& coverage, double least) {
    if (coverage.share() < least) {
        return Error{"points lie in " + std::to_string(std::lround(100.0 * coverage.share())) + " % of the image",
                     "lens",
                     "at least " + std::to_string(std::lround(100.0 * least)) +
                         " %: show the board in every corner and at the rims"};
    }
    return success();
}

/// What OpenCV says of the views that are used; the residuals are those views'.
struct LensFit {
    Lens lens{};
    double residual_px = 0.0;
    double focal_sigma_px = 0.0;
    std::vector<std::size_t> used{};  ///< views
    std::vector<double> residuals{};  ///< of each
    std::vector<Pose> boards{};       ///< where it was held, in the camera's frame
};

Pose pose_of_board(const cv::Mat& turn, const cv::Mat& shift) {
    const Vec3 turned(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
    const double angle = turned.norm();
    return {{shift.at<double>(0), shift.at<double>(1), shift.at<double>(2)},
            angle > 0.0 ? Quat(Eigen::AngleAxisd(angle, turned / angle)) : Quat::Identity()};
}

LensFit fit_lens(std::span<const BoardView> views, const std::vector<std::size_t>& used, const GridPlan& plan) {
    const std::vector<std::vector<cv::Point3f>> points(used.size(), points_of(plan));
    std::vector<std::vector<cv::Point2f>> pixels;
    for (const std::size_t i : used) {
        pixels.push_back(pixels_of(views[i]));
    }
    const cv::Size size(views.front().width, views.front().height);
    cv::Mat matrix;
    cv::Mat bends;
    cv::Mat sigmas;
    cv::Mat residuals;
    std::vector<cv::Mat> turns;
    std::vector<cv::Mat> shifts;
    LensFit fit;
    fit.residual_px =
        cv::calibrateCamera(points, pixels, size, matrix, bends, turns, shifts, sigmas, cv::noArray(), residuals);
    fit.lens = {matrix.at<double>(0, 0), matrix.at<double>(1, 1), matrix.at<double>(0, 2),
                matrix.at<double>(1, 2), bends.at<double>(0),     bends.at<double>(1),
                bends.at<double>(2),     bends.at<double>(3),     bends.at<double>(4)};
    fit.focal_sigma_px = sigmas.at<double>(0);
    fit.used = used;
    for (int i = 0; i < static_cast<int>(used.size()); ++i) {
        fit.residuals.push_back(residuals.at<double>(i));
        fit.boards.push_back(pose_of_board(turns[static_cast<std::size_t>(i)], shifts[static_cast<std::size_t>(i)]));
    }
    return fit;
}

double median_over_views(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Leaves out the worst view and fits again, until none is bad; at most half of them.
LensFit fit_without_bad(std::span<const BoardView> views, const GridPlan& plan, double bad_view,
                        std::vector<BoardFit>& fits) {
    std::vector<std::size_t> used(views.size());
    std::iota(used.begin(), used.end(), std::size_t{0});
    for (;;) {
        LensFit fit = fit_lens(views, used, plan);
        for (std::size_t i = 0; i < used.size(); ++i) {
            fits[used[i]] = {true, fit.residuals[i]};
        }
        const auto worst = std::max_element(fit.residuals.begin(), fit.residuals.end());
        if (*worst <= bad_view * median_over_views(fit.residuals) || 2 * used.size() <= views.size()) {
            return fit;
        }
        const std::ptrdiff_t at = worst - fit.residuals.begin();
        fits[used[static_cast<std::size_t>(at)]].used = false;
        used.erase(used.begin() + at);
    }
}

bool dots_are_told(std::span<const BoardView> views) {
    return std::all_of(views.begin(), views.end(),
                       [](const BoardView& view) { return view.areas.size() == view.points.size(); });
}

double radius_of_dots(std::span<const BoardView> views, const GridPlan& plan, const LensFit& fit) {
    std::vector<double> radii;
    for (std::size_t i = 0; i < fit.used.size(); ++i) {
        const std::vector<double>& areas = views[fit.used[i]].areas;
        for (int point = 0; point < plan.points(); ++point) {
            radii.push_back(dot_radius(fit.lens, fit.boards[i], point_of(plan, point), areas[rhexis::at(point)]));
        }
    }
    return median_over_views(std::move(radii));
}

/// Views that a lens was fitted to, with each point where the dot's centre is seen: not the middle of its image.
std::vector<BoardView> with_centres(std::span<const BoardView> views, const GridPlan& plan, const LensFit& fit,
                                    double radius_mm) {
    std::vector<BoardView> moved(views.begin(), views.end());
    for (std::size_t i = 0; i < fit.used.size(); ++i) {
        BoardView& view = moved[fit.used[i]];
        for (int point = 0; point < plan.points(); ++point) {
            view.points[rhexis::at(point)] -= dot_off(fit.lens, fit.boards[i], point_of(plan, point), radius_mm);
        }
    }
    return moved;
}

Status check_fit(const LensCalibration& result, const LensSettings& settings) {
    const auto used =
        std::count_if(result.views.begin(), result.views.end(), [](const BoardFit& fit) { return fit.used; });
    if (used < settings.fewest_views) {
        return Error{
            "only " + std::to_string(used) + " of " + std::to_string(result.views.size()) + " views fit one lens",
            "lens", "at least " + std::to_string(settings.fewest_views)};
    }
    if (!(result.residual_px <= settings.most_residual_px)) {
        return Error{"the residual is " + short_number(0.001 * std::round(1e3 * result.residual_px)) + " pixels",
                     "lens", "at most " + short_number(settings.most_residual_px) + ": a flat board, and sharp images"};
    }
    if (!(result.focal_sigma_px <= settings.most_focal_sigma * result.lens.fx)) {
        return Error{"the focal length is uncertain by " +
                         short_number(0.1 * std::round(10.0 * result.focal_sigma_px)) + " pixels",
                     "lens", "more views, slanted to different sides"};
    }
    return success();
}

}  // namespace

Result<LensCalibration> calibrate_lens(std::span<const BoardView> views, const GridPlan& plan,
                                       const LensSettings& settings) {
    for (const Status& status : {check_board(plan), check_views(views, plan, settings.fewest_views)}) {
        if (!status) {
            return status.error();
        }
    }
    LensCalibration result;
    result.width = views.front().width;
    result.height = views.front().height;
    result.coverage = coverage_of_views(views);
    result.views.resize(views.size());
    if (const Status status = check_coverage(result.coverage, settings.least_coverage); !status) {
        return status.error();
    }
    use_one_blas_thread();  // which OpenCV calls
    try {
        if (const Status status = check_slants(views, plan, settings); !status) {
            return status.error();
        }
        LensFit fit = fit_without_bad(views, plan, settings.bad_view, result.views);
        if (dots_are_told(views)) {
            result.dot_mm = radius_of_dots(views, plan, fit);
            fit = fit_lens(with_centres(views, plan, fit, result.dot_mm), fit.used, plan);
            for (std::size_t i = 0; i < fit.used.size(); ++i) {
                result.views[fit.used[i]].residual_px = fit.residuals[i];
            }
        }
        result.lens = fit.lens;
        result.residual_px = fit.residual_px;
        result.focal_sigma_px = fit.focal_sigma_px;
    } catch (const cv::Exception&) {  // of points that are no board's: all on a line, or all at one place
        return Error{"the points are not those of a flat board", "lens", "a board's points, row by row"};
    }
    if (const Status status = check_fit(result, settings); !status) {
        return status.error();
    }
    return result;
}

}  // namespace rhexis::tracking
