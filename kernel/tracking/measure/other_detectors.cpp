// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/other_detectors.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rhexis::tracking {
namespace {

constexpr double least_area = 12.0;
constexpr double most_area = 4000.0;

cv::Mat bright_pixels(const GreyImage& image, int threshold) {
    // OpenCV's headers take no constant memory; the image is only read.
    const cv::Mat all(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels),
                      static_cast<std::size_t>(image.stride));
    cv::Mat bright;
    cv::threshold(all, bright, threshold - 1, 255, cv::THRESH_BINARY);
    return bright;
}

double roundness_of(const cv::Moments& moments) {
    const double mean = 0.5 * (moments.mu20 + moments.mu02);
    const double apart = std::hypot(0.5 * (moments.mu20 - moments.mu02), moments.mu11);
    return mean + apart > 0.0 ? std::sqrt(std::max(mean - apart, 0.0) / (mean + apart)) : 0.0;
}

}  // namespace

std::vector<Spot> contour_spots(const GreyImage& image, int threshold) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(bright_pixels(image, threshold), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<Spot> spots;
    for (const std::vector<cv::Point>& contour : contours) {
        const cv::Moments moments = cv::moments(contour);
        if (moments.m00 < least_area || moments.m00 > most_area) {
            continue;
        }
        Spot spot;
        spot.at = {moments.m10 / moments.m00, moments.m01 / moments.m00};
        // A contour runs through the middles of its pixels: half of them lie outside.
        spot.area = moments.m00 + 0.5 * static_cast<double>(contour.size()) + 1.0;
        spot.roundness = roundness_of(moments);
        spots.push_back(spot);
    }
    return spots;
}

std::vector<Spot> component_spots(const GreyImage& image, int threshold) {
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centres;
    const int count = cv::connectedComponentsWithStats(bright_pixels(image, threshold), labels, stats, centres);
    std::vector<Spot> spots;
    for (int i = 1; i < count; ++i) {
        const double area = stats.at<int>(i, cv::CC_STAT_AREA);
        if (area >= least_area && area <= most_area) {
            Spot spot;
            spot.at = {centres.at<double>(i, 0), centres.at<double>(i, 1)};
            spot.area = area;
            spots.push_back(spot);
        }
    }
    return spots;
}

}  // namespace rhexis::tracking
