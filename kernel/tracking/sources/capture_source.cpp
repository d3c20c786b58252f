// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/capture_source.hpp"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

#include "base/clock.hpp"
#include "tracking/sources/grey.hpp"

namespace rhexis::tracking {
namespace {

bool is_device(const std::string& name) {
    return !name.empty() && name.size() <= 3 &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool open_one(cv::VideoCapture& capture, const std::string& name, const Camera& camera, double rate_hz) {
    if (!is_device(name)) {
        return capture.open(name);
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
        std::size_t come = 0;
        for (cv::VideoCapture& capture : captures_) {
            come += capture.grab() ? 1U : 0U;
        }
        if (come < captures_.size()) {
            if (!live_) {
                return false;  // the shortest file is over
            }
            return Error{"a camera gives no more images",
                         std::to_string(come) + " of " + std::to_string(captures_.size()) + " did",
                         "is its cable loose?"};
        }
        set.time_s = live_ ? wall_seconds() : static_cast<double>(count_) / rate_hz_;
        ++count_;
        for (std::size_t i = 0; i < captures_.size(); ++i) {
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

private:
    Rig rig_;
    std::vector<std::string> names_;
    std::vector<cv::VideoCapture> captures_;
    double rate_hz_;
    bool live_;
    std::uint64_t count_ = 0;
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
    double rate_hz = plan.rate_hz;
    for (std::size_t i = 0; i < plan.of.size(); ++i) {
        const Camera& camera = rig.cameras[i];
        cv::VideoCapture& capture = captures.emplace_back();
        if (!open_one(capture, plan.of[i], camera, plan.rate_hz)) {
            return Error{"camera \"" + camera.name + "\" cannot be opened", plan.of[i],
                         is_device(plan.of[i]) ? "is it plugged in, and may you use it?" : "a video file"};
        }
        live = live || is_device(plan.of[i]);
        if (const double own = capture.get(cv::CAP_PROP_FPS); own > 0.0 && !is_device(plan.of[i])) {
            rate_hz = own;
        }
    }
    return std::unique_ptr<FrameSource>(
        std::make_unique<CaptureSource>(rig, plan.of, std::move(captures), rate_hz, live));
}

}  // namespace rhexis::tracking
