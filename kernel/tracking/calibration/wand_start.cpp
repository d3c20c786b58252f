// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/wand_start.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <optional>

#include "math/blas.hpp"

namespace rhexis::tracking {
namespace {

/// The views that two cameras have of the same exposures.
struct PairViews {
    std::vector<const LabelledView*> one{};
    std::vector<const LabelledView*> other{};
};

const LabelledView* view_of(const LabelledFrame& frame, int camera) {
    const auto found = std::find_if(frame.views.begin(), frame.views.end(),
                                    [camera](const LabelledView& view) { return view.camera == camera; });
    return found == frame.views.end() ? nullptr : &*found;
}

PairViews views_of_pair(std::span<const LabelledFrame> frames, int one, int other) {
    PairViews views;
    for (const LabelledFrame& frame : frames) {
        const LabelledView* first = view_of(frame, one);
        const LabelledView* second = view_of(frame, other);
        if (first != nullptr && second != nullptr) {
            views.one.push_back(first);
            views.other.push_back(second);
        }
    }
    return views;
}

/// Up to 600 directions, spread over all views.
std::vector<cv::Point2d> directions_of_some(const std::vector<const LabelledView*>& views) {
    constexpr std::size_t most_views = 300;
    const std::size_t step = views.size() / most_views + 1;
    std::vector<cv::Point2d> points;
    for (std::size_t i = 0; i < views.size(); i += step) {
        points.emplace_back(views[i]->directions.front().x(), views[i]->directions.front().y());
        points.emplace_back(views[i]->directions.back().x(), views[i]->directions.back().y());
    }
    return points;
}

/// Median distance between the wand's ends, in units of the distance between the two cameras.
double seen_length(const PairViews& views, const Camera& one, const Camera& other) {
    const std::array<Camera, 2> cameras{one, other};
    std::vector<double> lengths;
    for (std::size_t i = 0; i < views.one.size(); ++i) {
        LabelledFrame frame{{*views.one[i], *views.other[i]}};
        frame.views[0].camera = 0;
        frame.views[1].camera = 1;
        const std::size_t last = frame.views[0].directions.size() - 1;
        lengths.push_back((meeting_point(cameras, frame, last) - meeting_point(cameras, frame, 0)).norm());
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

/// Pose of the second camera in the frame of the first, the distance between them 1.
std::optional<Pose> relative_pose(const PairViews& views, double focal_px) {
    constexpr double sure = 0.999;
    constexpr double near_px = 2.0;
    const std::vector<cv::Point2d> one = directions_of_some(views.one);
    const std::vector<cv::Point2d> other = directions_of_some(views.other);
    cv::Mat inside;
    const cv::Mat essential =
        cv::findEssentialMat(one, other, cv::Mat::eye(3, 3, CV_64F), cv::RANSAC, sure, near_px / focal_px, inside);
    if (essential.rows != 3 || essential.cols != 3) {
        return std::nullopt;
    }
    cv::Mat turn;
    cv::Mat shift;
    const int before_both = cv::recoverPose(essential, one, other, cv::Mat::eye(3, 3, CV_64F), turn, shift, inside);
    if (2 * before_both < static_cast<int>(one.size())) {
        return std::nullopt;
    }
    Mat3 rotation;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            rotation(i, j) = turn.at<double>(i, j);
        }
    }
    const Vec3 translation(shift.at<double>(0), shift.at<double>(1), shift.at<double>(2));
    return Pose{-(rotation.transpose() * translation), Quat(Mat3(rotation.transpose())).normalized()};
}

/// Places the second camera by the first; false: their views do not fit one another.
bool place_by(const Camera& placed, Camera& camera, const PairViews& views, double length_mm) {
    std::optional<Pose> relative;
    try {
        relative = relative_pose(views, std::sqrt(placed.lens.fx * camera.lens.fx));
    } catch (const cv::Exception&) {  // of sets of points that determine nothing
        return false;
    }
    if (!relative) {
        return false;
    }
    Camera at_origin = placed;
    at_origin.pose = Pose{};
    Camera beside = camera;
    beside.pose = *relative;
    const double length = seen_length(views, at_origin, beside);
    if (!(length > 0.0) || !std::isfinite(length)) {
        return false;
    }
    camera.pose.position = placed.pose.to_world(relative->position * (length_mm / length));
    camera.pose.orientation = (placed.pose.orientation * relative->orientation).normalized();
    return true;
}

/// Cameras that are linked to the first one by pairs that share enough.
std::vector<bool> linked_to_first(const Eigen::MatrixXi& shared, int fewest) {
    std::vector<bool> linked(static_cast<std::size_t>(shared.rows()), false);
    std::vector<Eigen::Index> next{0};
    linked[0] = true;
    while (!next.empty()) {
        const Eigen::Index from = next.back();
        next.pop_back();
        for (Eigen::Index to = 0; to < shared.rows(); ++to) {
            if (!linked[static_cast<std::size_t>(to)] && shared(from, to) >= fewest) {
                linked[static_cast<std::size_t>(to)] = true;
                next.push_back(to);
            }
        }
    }
    return linked;
}

std::string names_of(const std::vector<Camera>& cameras, const std::vector<bool>& wanted, bool value) {
    std::string names;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (wanted[i] == value) {
            names += (names.empty() ? "" : ", ") + cameras[i].name;
        }
    }
    return names;
}

Status check_links(const std::vector<Camera>& cameras, const Eigen::MatrixXi& shared, int fewest) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (shared(at, at) == 0) {
            return Error{"camera \"" + cameras[i].name + "\" never sees the wand", "wand",
                         "each camera sees all of its spheres in many frames"};
        }
    }
    const std::vector<bool> linked = linked_to_first(shared, fewest);
    if (std::find(linked.begin(), linked.end(), false) != linked.end()) {
        return Error{"cameras " + names_of(cameras, linked, true) + " and cameras " + names_of(cameras, linked, false) +
                         " share too few frames",
                     "wand", "at least " + std::to_string(fewest) + " frames that a camera of each group sees"};
    }
    return success();
}

struct CameraPair {
    Eigen::Index placed = -1;
    Eigen::Index other = -1;
};

/// The pair of a placed camera and one that is not, untried, with most frames; none: -1.
CameraPair next_pair(const Eigen::MatrixXi& left, const std::vector<bool>& placed, int fewest) {
    CameraPair best;
    int most = fewest - 1;
    for (Eigen::Index i = 0; i < left.rows(); ++i) {
        for (Eigen::Index j = 0; j < left.rows(); ++j) {
            if (placed[static_cast<std::size_t>(i)] && !placed[static_cast<std::size_t>(j)] && left(i, j) > most) {
                most = left(i, j);
                best = {i, j};
            }
        }
    }
    return best;
}

}  // namespace

Eigen::MatrixXi shared_frames(std::span<const LabelledFrame> frames, std::size_t cameras) {
    const auto count = static_cast<Eigen::Index>(cameras);
    Eigen::MatrixXi shared = Eigen::MatrixXi::Zero(count, count);
    for (const LabelledFrame& frame : frames) {
        for (const LabelledView& one : frame.views) {
            for (const LabelledView& other : frame.views) {
                ++shared(one.camera, other.camera);
            }
        }
    }
    return shared;
}

Result<std::vector<Camera>> start_of_wand(std::vector<Camera> cameras, double length_mm,
                                          std::span<const LabelledFrame> frames, int fewest_shared) {
    use_one_blas_thread();  // which OpenCV calls
    Eigen::MatrixXi left = shared_frames(frames, cameras.size());
    if (const Status status = check_links(cameras, left, fewest_shared); !status) {
        return status.error();
    }
    std::vector<bool> placed(cameras.size(), false);
    placed[0] = true;
    while (std::find(placed.begin(), placed.end(), false) != placed.end()) {
        const CameraPair pair = next_pair(left, placed, fewest_shared);
        if (pair.other < 0) {
            return Error{"what camera " + names_of(cameras, placed, false) + " sees does not fit what the others see",
                         "wand", "lenses that are calibrated, a wand moved through the whole space, and a still rig"};
        }
        const PairViews views = views_of_pair(frames, static_cast<int>(pair.placed), static_cast<int>(pair.other));
        const auto other = static_cast<std::size_t>(pair.other);
        placed[other] = place_by(cameras[static_cast<std::size_t>(pair.placed)], cameras[other], views, length_mm);
        left(pair.placed, pair.other) = 0;
    }
    return cameras;
}

}  // namespace rhexis::tracking
