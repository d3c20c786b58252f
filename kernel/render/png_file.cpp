// SPDX-License-Identifier: GPL-3.0-or-later
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string_view>

#include "base/output_file.hpp"
#include "render/image_file.hpp"

namespace rhexis {

Status write_png(const Image& image, const std::string& path) {
    if (image.width < 1 || image.height < 1 ||
        image.rgb.size() != 3 * static_cast<std::size_t>(image.width) * image.height) {
        return Error{"the picture is empty", path, "at least 1 x 1 pixels"};
    }
    const cv::Mat rgb(image.height, image.width, CV_8UC3, const_cast<unsigned char*>(image.rgb.data()));
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    std::vector<unsigned char> bytes;
    cv::imencode(".png", bgr, bytes);
    const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const Status written = write_file(path, content);
    if (written) {
        return written;
    }
    const std::string& why = written.error().what;
    const std::string::size_type colon = why.find(": ");
    return Error{"cannot write the picture: " + (colon == std::string::npos ? why : why.substr(colon + 2)), path,
                 "a writable path with room"};
}

}  // namespace rhexis
