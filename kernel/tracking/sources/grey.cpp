// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/grey.hpp"

#include <opencv2/imgproc.hpp>

namespace rhexis::tracking {

Status check_size(int width, int height, const Camera& camera, const std::string& where) {
    if (width != camera.width || height != camera.height) {
        return Error{
            "an image of " + std::to_string(width) + " x " + std::to_string(height), where,
            "\"" + camera.name + "\" has " + std::to_string(camera.width) + " x " + std::to_string(camera.height)};
    }
    return success();
}

Status grey_frame(const cv::Mat& image, const Camera& camera, const std::string& where, CameraFrame& frame) {
    if (image.empty() || image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
        return Error{"this is no image of 8 bits", where, "grey or of three colours"};
    }
    if (Status fits = check_size(image.cols, image.rows, camera, where); !fits) {
        return fits;
    }
    frame.width = image.cols;
    frame.height = image.rows;
    frame.pixels.resize(static_cast<std::size_t>(image.cols) * static_cast<std::size_t>(image.rows));
    cv::Mat grey(image.rows, image.cols, CV_8UC1, frame.pixels.data());
    if (image.channels() == 3) {
        cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    } else {
        image.copyTo(grey);
    }
    return success();
}

}  // namespace rhexis::tracking
