// SPDX-License-Identifier: GPL-3.0-or-later
#include "video/video_file.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "base/output_file.hpp"
#include "video/mp4_boxes.hpp"

namespace rhexis {

namespace {

struct Codec {
    const char* name;
    std::array<char, 4> code;
};

/// In order of preference: browsers play only the first.
constexpr std::array<Codec, 2> codecs{{{"H.264", {'a', 'v', 'c', '1'}}, {"MPEG-4", {'m', 'p', '4', 'v'}}}};

/// OpenCV reports a codec that this machine lacks on stderr, although another is tried next.
class QuietOpenCv {
public:
    QuietOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
    ~QuietOpenCv() { cv::utils::logging::setLogLevel(before_); }
    QuietOpenCv(const QuietOpenCv&) = delete;
    QuietOpenCv& operator=(const QuietOpenCv&) = delete;

private:
    cv::utils::logging::LogLevel before_;
};

Error cannot_write_video(const std::string& what, const std::string& path) {
    return Error{"cannot write the video: " + what, path, "a writable path with room"};
}

bool ends_in(const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The codec libraries say nothing of a file that they cannot open.
Status check_writable(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) {
        return cannot_write_video(std::strerror(errno), path);
    }
    std::fclose(file);
    return success();
}

/// Where the codec library writes, which goes back and forth in it: beside the video, or where it may if that is no
/// file.
std::string part_of(const OutputPlace& place) {
    std::error_code ignored;
    const std::string whole =
        place.plain
            ? place.path
            : (std::filesystem::temp_directory_path(ignored) / ("rhexis-" + std::to_string(::getpid()))).string();
    const std::string ending = ends_in(whole, ".mp4") ? ".mp4" : "";
    return whole.substr(0, whole.size() - ending.size()) + ".part.mp4";
}

int readable_frames(const std::string& path) {
    // The codec libraries write to stderr about a file that was cut off.
    if (!is_whole_mp4(path)) {
        return 0;
    }
    cv::VideoCapture video(path, cv::CAP_FFMPEG);
    return video.isOpened() ? static_cast<int>(std::lround(video.get(cv::CAP_PROP_FRAME_COUNT))) : 0;
}

class VideoFile final : public Video {
public:
    VideoFile(std::string path, std::string part, int width, int height)
        : path_(std::move(path)), part_(std::move(part)), width_(width), height_(height) {}
    ~VideoFile() override {
        writer_.release();
        if (!part_.empty()) {
            std::remove(part_.c_str());
        }
    }

    bool open(double frames_per_second) {
        const QuietOpenCv quiet;
        for (const Codec& one : codecs) {
            const int code = cv::VideoWriter::fourcc(one.code[0], one.code[1], one.code[2], one.code[3]);
            if (writer_.open(part_, cv::CAP_FFMPEG, code, frames_per_second, cv::Size(width_, height_))) {
                codec_ = one.name;
                return true;
            }
        }
        return false;
    }

    Status add(const Image& image) override {
        if (image.width != width_ || image.height != height_) {
            return Error{
                "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels", path_,
                "the video's size, " + std::to_string(width_) + " x " + std::to_string(height_)};
        }
        RHEXIS_ASSERT(writer_.isOpened());
        const cv::Mat rgb(image.height, image.width, CV_8UC3, const_cast<unsigned char*>(image.rgb.data()));
        cv::cvtColor(rgb, bgr_, cv::COLOR_RGB2BGR);
        writer_.write(bgr_);
        ++frames_;
        return success();
    }

    Status finish() override {
        if (frames_ == 0) {
            return cannot_write_video("it has no pictures", path_);
        }
        writer_.release();
        const QuietOpenCv quiet;
        const int readable = readable_frames(part_);
        if (readable != frames_) {
            return cannot_write_video(
                "only " + std::to_string(readable) + " of " + std::to_string(frames_) + " pictures can be read back",
                path_);
        }
        const Status written = write_index_first(part_, path_);
        if (!written.ok()) {
            return cannot_write_video(written.error().what, path_);
        }
        std::remove(part_.c_str());
        part_.clear();
        return success();
    }

    [[nodiscard]] const std::string& codec() const override { return codec_; }

private:
    std::string path_;
    std::string part_;  ///< name while it is written; the ending tells the container
    std::string codec_{};
    int width_;
    int height_;
    int frames_ = 0;
    cv::VideoWriter writer_{};
    cv::Mat bgr_{};
};

Status check_plan(const std::string& path, int width, int height, double frames_per_second) {
    if (!ends_in(path, ".mp4")) {
        return Error{"this is not the name of a video", path, "a name that ends in .mp4"};
    }
    if (width < 16 || height < 16 || width > 4096 || height > 4096 || width % 2 != 0 || height % 2 != 0) {
        return Error{"a video of " + std::to_string(width) + " x " + std::to_string(height) + " pixels", path,
                     "even numbers, 16 to 4096 each way"};
    }
    if (!(frames_per_second >= 1.0 && frames_per_second <= 240.0)) {
        return Error{"a video of " + std::to_string(frames_per_second) + " pictures per second", path, "1 to 240"};
    }
    return success();
}

}  // namespace

Result<std::unique_ptr<Video>> create_video_file(const std::string& path, int width, int height,
                                                 double frames_per_second) {
    if (const Status possible = check_plan(path, width, height, frames_per_second); !possible) {
        return possible.error();
    }
    const Result<OutputPlace> place = output_place(path);
    if (!place) {
        return cannot_write_video(place.error().what, path);
    }
    const std::string part = part_of(place.value());
    if (const Status status = check_writable(part); !status.ok()) {
        return Error{status.error().what, path, status.error().allowed};
    }
    auto file = std::make_unique<VideoFile>(path, part, width, height);
    if (!file->open(frames_per_second)) {
        return cannot_write_video("this machine encodes neither H.264 (avc1) nor MPEG-4 (mp4v)", path);
    }
    return std::unique_ptr<Video>(std::move(file));
}

}  // namespace rhexis
