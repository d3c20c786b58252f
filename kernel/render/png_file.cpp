// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "render/image_file.hpp"

namespace rhexis {

namespace {

Error cannot_write_png(const std::string& path, int reason) {
    return Error{std::string("cannot write the picture: ") + std::strerror(reason), path, "a writable path with room"};
}

Status write_bytes(const std::vector<unsigned char>& bytes, const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) {
        return cannot_write_png(path, errno);
    }
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int reason = errno;
    errno = 0;
    if (std::fclose(file) == 0 && written) {
        return success();
    }
    return cannot_write_png(path, written ? errno : reason);
}

}  // namespace

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
    const std::string part = path + ".part";
    if (const Status status = write_bytes(bytes, part); !status.ok()) {
        std::remove(part.c_str());
        return Error{status.error().what, path, status.error().allowed};
    }
    if (std::rename(part.c_str(), path.c_str()) != 0) {
        const int reason = errno;
        std::remove(part.c_str());
        return cannot_write_png(path, reason);
    }
    return success();
}

}  // namespace rhexis
