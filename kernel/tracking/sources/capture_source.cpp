// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/capture_source.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <optional>

#include "base/clock.hpp"
#include "base/numbers.hpp"
#include "tracking/sources/grey.hpp"

namespace rhexis::tracking {
namespace {

constexpr double least_rate_step = 0.01;  ///< between rates that are two [1/s]

bool is_device(const std::string& name) {
    return !name.empty() && name.size() <= 3 &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool open_one(cv::VideoCapture& capture, const std::string& name, const Camera& camera, double rate_hz) {
    if (!is_device(name)) {
        // Not whichever of OpenCV's readers takes it: some look for photo cameras at USB, and never give that list
        // back.
        return capture.open(name, cv::CAP_FFMPEG);
    }
    return capture.open(std::stoi(name), cv::CAP_V4L2) && capture.set(cv::CAP_PROP_FRAME_WIDTH, camera.width) &&
           capture.set(cv::CAP_PROP_FRAME_HEIGHT, camera.height) && capture.set(cv::CAP_PROP_FPS, rate_hz);
}

class CaptureSource final : public FrameSource {
public:
    CaptureSource(const Rig& rig, std::vector<std::string> names, std::vector<cv::VideoCapture> captures,
                  double rate_hz, bool live)
        : rig_(rig), names_(std::move(names)), captures_(std::move(captures)), rate_hz_(rate_hz), live_(live) {}

    Result<bool> next(FrameSet& set) override {
        set.frames.clear();
        std::vector<std::size_t> come;
        for (std::size_t i = 0; i < captures_.size(); ++i) {
            if (captures_[i].grab()) {
                come.push_back(i);
            } else if (live_) {
                return Error{"camera \"" + rig_.cameras[i].name + "\" gives no more images", names_[i],
                             "is its cable loose?"};
            }
        }
        if (come.empty()) {
            return false;
        }
        lost_ += captures_.size() - come.size();
        set.time_s = live_ ? wall_seconds() : static_cast<double>(count_) / rate_hz_;
        ++count_;
        for (const std::size_t i : come) {
            cv::Mat image;
            CameraFrame frame{static_cast<int>(i), set.time_s, 0, 0, {}};
            captures_[i].retrieve(image);
            if (const Status read = grey_frame(image, rig_.cameras[i], names_[i], frame); !read) {
                return read.error();
            }
            set.frames.push_back(std::move(frame));
        }
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return rate_hz_; }
    [[nodiscard]] std::uint64_t lost() const override { return lost_; }

private:
    Rig rig_;
    std::vector<std::string> names_;
    std::vector<cv::VideoCapture> captures_;
    double rate_hz_;
    bool live_;
    std::uint64_t count_ = 0;
    std::uint64_t lost_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_capture(const CapturePlan& plan, const Rig& rig) {
    if (plan.of.size() != rig.cameras.size()) {
        return Error{std::to_string(plan.of.size()) + " devices for " + std::to_string(rig.cameras.size()) + " cameras",
                     "", "one for each, in the order of the rig"};
    }
    // What cannot be opened is told below, in one line.
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    std::vector<cv::VideoCapture> captures;
    bool live = false;
    std::optional<double> of_files;
    for (std::size_t i = 0; i < plan.of.size(); ++i) {
        const Camera& camera = rig.cameras[i];
        cv::VideoCapture& capture = captures.emplace_back();
        if (!open_one(capture, plan.of[i], camera, plan.rate_hz)) {
            return Error{"camera \"" + camera.name + "\" cannot be opened", plan.of[i],
                         is_device(plan.of[i]) ? "is it plugged in, and may you use it?" : "a video file"};
        }
        if (const Status fits =
                check_size(static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH)),
                           static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT)), camera, plan.of[i]);
            !fits) {
            return fits.error();
        }
        live = live || is_device(plan.of[i]);
        const double own = is_device(plan.of[i]) ? 0.0 : capture.get(cv::CAP_PROP_FPS);
        if (own > 0.0 && std::abs(own - of_files.value_or(own)) > least_rate_step) {
            return Error{"images were taken at " + short_number(own) + " a second", plan.of[i],
                         short_number(*of_files) + ", as those before"};
        }
        of_files = own > 0.0 ? own : of_files;
    }
    const double rate_hz = live ? plan.rate_hz : of_files.value_or(plan.rate_hz);
    return std::unique_ptr<FrameSource>(
        std::make_unique<CaptureSource>(rig, plan.of, std::move(captures), rate_hz, live));
}

}  // namespace rhexis::tracking
