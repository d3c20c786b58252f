// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/wand.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "base/numbers.hpp"
#include "tracking/calibration/wand_adjustment.hpp"
#include "tracking/calibration/wand_start.hpp"

namespace rhexis::tracking {
namespace {

constexpr double shortest_wand_mm = 20.0;
constexpr double longest_wand_mm = 2000.0;

Status check_gaps(const Wand& wand) {
    constexpr double least_ratio = 1.25;
    for (std::size_t i = 1; i < wand.at_mm.size(); ++i) {
        if (!(wand.at_mm[i] > wand.at_mm[i - 1])) {
            return Error{"the places of the wand's spheres do not rise", "wand",
                         "along it, each beyond the one before"};
        }
    }
    if (wand.at_mm.size() == 3) {
        const double first = wand.at_mm[1] - wand.at_mm[0];
        const double second = wand.at_mm[2] - wand.at_mm[1];
        const double ratio = std::max(first, second) / std::min(first, second);
        if (ratio < least_ratio) {
            return Error{"the gaps between the wand's spheres are " + short_number(first) + " and " +
                             short_number(second) + " mm",
                         "wand", "one is at least a quarter longer than the other"};
        }
    }
    return success();
}

Status check_wand(const Wand& wand) {
    if (wand.at_mm.size() < 2 || wand.at_mm.size() > 3) {
        return Error{"a wand of " + std::to_string(wand.at_mm.size()) + " spheres", "wand", "2 or 3"};
    }
    if (const Status status = check_range("length", wand.length_mm(), shortest_wand_mm, longest_wand_mm, "wand", "mm");
        !status) {
        return status;
    }
    for (const Status& status : {check_range("sigma", wand.sigma_mm, 1e-6, 10.0, "wand", "mm"),
                                 check_range("radius", wand.radius_mm, 0.0, 20.0, "wand", "mm")}) {
        if (!status) {
            return status;
        }
    }
    return check_gaps(wand);
}

Status check_frames(const Rig& rig, std::span<const WandFrame> frames) {
    if (rig.cameras.size() < 2 || rig.cameras.size() > 16) {
        return Error{std::to_string(rig.cameras.size()) + " cameras", "wand", "2 to 16"};
    }
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<bool> has_view(rig.cameras.size(), false);
        for (const WandView& view : frames[i].views) {
            const auto camera = static_cast<std::size_t>(view.camera);
            const std::string where = "wand, frame " + std::to_string(i + 1);
            if (view.camera < 0 || camera >= rig.cameras.size()) {
                return Error{"a view of camera " + std::to_string(view.camera), where,
                             range_text(0, static_cast<double>(rig.cameras.size() - 1))};
            }
            if (has_view[camera]) {
                return Error{"two views of camera \"" + rig.cameras[camera].name + "\"", where, "one of each camera"};
            }
            has_view[camera] = true;
            if (!std::all_of(view.spots.begin(), view.spots.end(), [](const Vec2& spot) { return spot.allFinite(); })) {
                return Error{"a spot of camera \"" + rig.cameras[camera].name + "\" is not a number", where, "pixels"};
            }
        }
    }
    return success();
}

/// Frames that at least two cameras saw.
std::vector<LabelledFrame> labelled(std::span<const Camera> cameras, const Wand& wand,
                                    std::span<const WandFrame> frames, bool by_poses) {
    std::vector<LabelledFrame> result;
    for (const WandFrame& frame : frames) {
        LabelledFrame one = by_poses ? label_by_poses(cameras, wand, frame) : label_by_gaps(cameras, wand, frame);
        if (one.views.size() >= 2) {
            result.push_back(std::move(one));
        }
    }
    return result;
}

Status check_enough(std::size_t frames, int fewest) {
    if (frames < static_cast<std::size_t>(std::max(1, fewest))) {
        return Error{"only " + std::to_string(frames) + " frames in which two cameras see the whole wand", "wand",
                     "at least " + std::to_string(fewest)};
    }
    return success();
}

/// Drops what does not fit, and adjusts. Frames with a wrong spot, or with a wand that was taken the other way round,
/// weigh a lot while the poses are still wrong: under Huber's loss an adjustment to the end would creep after them.
Result<int> adjust_without_outliers(WandEstimate& estimate, const Wand& wand, const WandSettings& settings) {
    constexpr double wild = 10.0;  // times the median of worst residuals: before all is adjusted
    constexpr double apart = 3.0;  // likewise, afterwards: about 8 standard deviations of a spot
    drop_outliers(estimate, wand, wild);
    int iterations = approach(estimate, wand, settings);
    drop_outliers(estimate, wand, wild);
    for (const bool last : {false, true}) {
        if (const Status status = check_enough(estimate.frames.size(), settings.fewest_frames); !status) {
            return status.error();
        }
        const Result<int> more = adjust(estimate, wand, settings);
        if (!more) {
            return more;
        }
        iterations += more.value();
        if (last || drop_outliers(estimate, wand, apart) == 0) {
            break;
        }
    }
    return iterations;
}

/// Squares of both coordinates, of each camera.
void measure_residuals(const WandEstimate& estimate, const Wand& wand, WandCalibration& result) {
    std::vector<double> squares(estimate.cameras.size(), 0.0);
    std::vector<double> counts(estimate.cameras.size(), 0.0);
    result.cameras.assign(estimate.cameras.size(), {});
    for (const LabelledFrame& frame : estimate.frames) {
        for (const LabelledView& view : frame.views) {
            ++result.cameras[static_cast<std::size_t>(view.camera)].views;
        }
    }
    for (const SpotOff& spot : spot_offs(estimate, wand)) {
        squares[static_cast<std::size_t>(spot.camera)] += spot.off.squaredNorm();
        counts[static_cast<std::size_t>(spot.camera)] += 2.0;
    }
    double all_squares = 0.0;
    double all_counts = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        result.cameras[i].residual_px = std::sqrt(squares[i] / std::max(1.0, counts[i]));
        all_squares += squares[i];
        all_counts += counts[i];
    }
    result.residual_px = std::sqrt(all_squares / std::max(1.0, all_counts));
}

/// Points that the alignment keeps together: centres, and where those lie on a line what is 100 mm before and beside.
MatX points_to_align(const std::vector<Camera>& cameras, bool with_axes) {
    constexpr double reach_mm = 100.0;
    const Eigen::Index each = with_axes ? 3 : 1;
    MatX points(3, each * static_cast<Eigen::Index>(cameras.size()));
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Eigen::Index at = each * static_cast<Eigen::Index>(i);
        points.col(at) = cameras[i].pose.position;
        if (with_axes) {
            points.col(at + 1) = cameras[i].pose.to_world({0.0, 0.0, reach_mm});
            points.col(at + 2) = cameras[i].pose.to_world({reach_mm, 0.0, 0.0});
        }
    }
    return points;
}

bool on_a_line(const std::vector<Camera>& cameras) {
    constexpr double width_mm = 10.0;
    const MatX points = points_to_align(cameras, false);
    const Vec3 middle = points.rowwise().mean();
    const MatX spread = points.colwise() - middle;
    const Eigen::JacobiSVD<MatX> factors(spread);
    return factors.singularValues().size() < 2 || factors.singularValues()[1] < width_mm;
}

void align_to(const std::vector<Camera>& given, std::vector<Camera>& cameras) {
    const bool with_axes = on_a_line(given);
    const Eigen::Matrix4d motion =
        Eigen::umeyama(points_to_align(cameras, with_axes), points_to_align(given, with_axes), false);
    const Mat3 turn = motion.topLeftCorner<3, 3>();
    const Vec3 shift = motion.topRightCorner<3, 1>();
    for (Camera& camera : cameras) {
        camera.pose.position = turn * camera.pose.position + shift;
        camera.pose.orientation = (Quat(turn) * camera.pose.orientation).normalized();
    }
}

Status measure_certainty(const WandEstimate& estimate, const Wand& wand, const WandSettings& settings,
                         WandCalibration& result) {
    const Result<WandCertainty> certainty = certainty_of(estimate, wand, settings);
    if (!certainty) {
        return certainty.error();
    }
    const double wider = std::max(1.0, result.residual_px / settings.spot_sigma_px);
    for (std::size_t i = 0; i < result.cameras.size(); ++i) {
        result.cameras[i].position_sigma_mm = wider * certainty.value().position_sigma_mm[i];
    }
    result.scale_sigma = certainty.value().length_sigma_mm / estimate.length_mm;
    return success();
}

/// Labels once more by poses, now that they are nearly right.
Result<WandEstimate> started(const Rig& given, const Wand& wand, std::span<const WandFrame> frames,
                             const WandSettings& settings) {
    std::vector<LabelledFrame> seen = labelled(given.cameras, wand, frames, wand.at_mm.size() == 2);
    if (const Status status = check_enough(seen.size(), settings.fewest_frames); !status) {
        return status.error();
    }
    Result<std::vector<Camera>> cameras =
        start_of_wand(given.cameras, wand.length_mm(), seen, settings.fewest_shared_frames);
    if (!cameras) {
        return cameras.error();
    }
    seen = labelled(cameras.value(), wand, frames, true);
    if (const Status status = check_enough(seen.size(), settings.fewest_frames); !status) {
        return status.error();
    }
    return wand_estimate(std::move(cameras).value(), std::move(seen), wand.length_mm());
}

}  // namespace

Result<WandCalibration> calibrate_wand(const Rig& given, const Wand& wand, std::span<const WandFrame> frames,
                                       const WandSettings& settings) {
    const double begun_s = thread_cpu_seconds();
    for (const Status& status : {check_wand(wand), check_frames(given, frames)}) {
        if (!status) {
            return status.error();
        }
    }
    Result<WandEstimate> start = started(given, wand, frames, settings);
    if (!start) {
        return start.error();
    }
    WandEstimate& estimate = start.value();
    const std::size_t all_frames = estimate.frames.size();
    const Result<int> iterations = adjust_without_outliers(estimate, wand, settings);
    if (!iterations) {
        return iterations.error();
    }
    WandCalibration result;
    measure_residuals(estimate, wand, result);
    if (const Status status = measure_certainty(estimate, wand, settings, result); !status) {
        return status.error();
    }
    if (settings.frame == RigFrame::nominal) {
        align_to(given.cameras, estimate.cameras);
    }
    result.rig = {estimate.cameras, true};
    result.frames_used = static_cast<int>(estimate.frames.size());
    result.frames_dropped = static_cast<int>(all_frames - estimate.frames.size());
    result.iterations = iterations.value();
    result.seconds = thread_cpu_seconds() - begun_s;
    return result;
}

}  // namespace rhexis::tracking
