// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/board_finder.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "base/assert.hpp"
#include "tracking/spots/spot_finder.hpp"

namespace rhexis::tracking {
namespace {

/// Spots that may be dots: whole, and about as large as most of them.
std::vector<Spot> dots_in(const cv::Mat& image, const GridPlan& plan) {
    cv::Mat bright;
    SpotSettings settings;
    settings.threshold =
        std::clamp(static_cast<int>(cv::threshold(image, bright, 0, 255, cv::THRESH_OTSU)) + 1, 5, 250);
    settings.most_spots = 3 * plan.points() + 20;
    settings.outline.stretch_px = 10.0;  // a slanted dot is an ellipse
    SpotFinder finder(settings);
    std::vector<Spot> spots = finder.find({image.data, image.cols, image.rows, static_cast<int>(image.step)}).spots;
    std::erase_if(spots, [](const Spot& spot) { return spot.at_rim || spot.roundness < 0.4; });
    if (spots.empty()) {
        return spots;
    }
    std::vector<double> areas;
    std::transform(spots.begin(), spots.end(), std::back_inserter(areas), [](const Spot& spot) { return spot.area; });
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    std::erase_if(spots, [usual = *middle](const Spot& spot) {
        constexpr double alike = 3.0;  // a dot farther away or more slanted is smaller
        return spot.area > alike * usual || spot.area * alike < usual;
    });
    return spots;
}

const Spot* spot_at(const std::vector<Spot>& spots, const cv::Point2f& place) {
    constexpr double same_px = 0.01;  // what is farther off was made up by the search
    const auto found = std::find_if(spots.begin(), spots.end(), [&place](const Spot& spot) {
        return (spot.at - Vec2(place.x, place.y)).norm() < same_px;
    });
    return found == spots.end() ? nullptr : &*found;
}

/// Dots in rows; false: they are no board's.
bool put_dots_in_rows(const std::vector<Spot>& spots, const GridPlan& plan, BoardView& view) {
    if (spots.size() < static_cast<std::size_t>(plan.points())) {
        return false;
    }
    std::vector<cv::Point2f> places;
    for (const Spot& spot : spots) {
        places.emplace_back(static_cast<float>(spot.at.x()), static_cast<float>(spot.at.y()));
    }
    std::vector<cv::Point2f> in_rows;
    if (!cv::findCirclesGrid(places, {plan.columns, plan.rows}, in_rows, cv::CALIB_CB_SYMMETRIC_GRID, nullptr)) {
        return false;
    }
    for (const cv::Point2f& place : in_rows) {
        const Spot* spot = spot_at(spots, place);
        if (spot == nullptr) {
            return false;
        }
        view.points.push_back(spot->at);
        view.areas.push_back(spot->area);
    }
    return true;
}

bool find_dots(const cv::Mat& image, const GridPlan& plan, BoardView& view) {
    if (put_dots_in_rows(dots_in(image, plan), plan, view)) {
        return true;
    }
    cv::Mat inverse;
    cv::bitwise_not(image, inverse);
    view.points.clear();
    view.areas.clear();
    return put_dots_in_rows(dots_in(inverse, plan), plan, view);
}

bool find_corners(const cv::Mat& image, const GridPlan& plan, BoardView& view) {
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCornersSB(image, {plan.columns, plan.rows}, corners)) {
        return false;
    }
    constexpr int reach_px = 5;
    const cv::TermCriteria still(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-3);
    cv::cornerSubPix(image, corners, {reach_px, reach_px}, {-1, -1}, still);
    for (const cv::Point2f& corner : corners) {
        view.points.emplace_back(corner.x, corner.y);
    }
    return true;
}

}  // namespace

std::optional<BoardView> find_board(const GreyImage& image, const GridPlan& plan, const std::string& name) {
    RHEXIS_ASSERT(image.pixels != nullptr && image.stride >= image.width);
    // OpenCV's header wants what it may write to, though no search writes.
    const cv::Mat view(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels),
                       static_cast<std::size_t>(image.stride));
    BoardView result{name, image.width, image.height};
    try {
        if (!(plan.kind == GridKind::chess ? find_corners(view, plan, result) : find_dots(view, plan, result))) {
            return std::nullopt;
        }
    } catch (const cv::Exception&) {  // of images in which nothing can be sought
        return std::nullopt;
    }
    if (result.points.size() != static_cast<std::size_t>(plan.points())) {
        return std::nullopt;
    }
    return result;
}

}  // namespace rhexis::tracking
