// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/live_picture.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "station/person.hpp"
#include "station/window/read_window.hpp"

namespace rhexis::station {
namespace {

/// Shares of the window's size that a picture may have, so that there are enough of them.
constexpr std::array picture_sizes = {1.0, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35};
constexpr double least_rate = 15.0;    ///< pictures per second: below, they are drawn smaller
constexpr std::size_t looked_at = 24;  ///< pictures, before that is decided,
constexpr double looked_at_s = 1.5;    ///< or as many as there are in so long, but so many:
constexpr std::size_t least_looked_at = 9;
constexpr double coarse_share = 0.5;  ///< of the size of a picture while the eye moves under the microscope
constexpr double still_mm = 0.02;     ///< from picture to picture: half a pixel,
constexpr double turned_mm = 0.4;     ///< and of the camera about the eye, 200 mm away: as much at the eye's wall

}  // namespace

LivePicture::LivePicture(Window& window, Panels& panels, Renderer renderer, HoldScript holds, const Wishes& wishes)
    : window_(window),
      panels_(panels),
      wishes_(wishes),
      renderer_(std::make_unique<Renderer>(std::move(renderer))),
      holds_(std::move(holds)),
      begun_s_(wall_seconds()) {}

std::vector<UserEvent> LivePicture::draw(Shown& shown, const std::vector<UserEvent>& after, Image* taken) {
    run_ahead(shown, after);
    const double before = wall_seconds();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window_.width(), window_.height());
    const Camera camera = adjusted(microscope_camera(shown.frame), shown.hands);
    renderer_for(shown.frame, camera)
        .show(shown.frame, camera, {0, 0, window_.width(), window_.height()}, wishes_.stereo);
    std::vector<UserEvent> clicked =
        panels_.draw(shown, wishes_.ghost, {rate_, picture_sizes[static_cast<std::size_t>(size_)]});
    if (taken != nullptr) {
        *taken = read_window(window_);
    }
    window_.present();
    count(wall_seconds() - before);
    return clicked;
}

bool LivePicture::moves(const Frame& frame, const Camera& camera) {
    if (!frame.eye) {
        return false;
    }
    const Camera seen =
        frame.globe && frame.model->globe ? camera_in_eye(camera, *frame.model->globe, *frame.globe) : camera;
    const Sight before = std::exchange(sight_, {seen.eye, seen.target, seen.focus_mm, frame.eye->pupil_radius});
    return ((sight_.camera - sight_.target) - (before.camera - before.target)).norm() > turned_mm ||
           (sight_.target - before.target).norm() > still_mm ||
           std::abs(sight_.focus_mm - before.focus_mm) > still_mm ||
           std::abs(sight_.pupil_radius - before.pupil_radius) > still_mm;
}

/// While the eye moves under the microscope every place of a picture is new: it is drawn in a fourth of the pixels, and
/// sharp again when it stands.
Renderer& LivePicture::renderer_for(const Frame& frame, const Camera& camera) {
    if (!moves(frame, camera) || !wishes_.keep_rate) {
        return *renderer_;
    }
    if (coarse_ == nullptr) {
        const double share = coarse_share * picture_sizes[static_cast<std::size_t>(size_)];
        Result<Renderer> coarse = Renderer::create_in_window(static_cast<int>(share * window_.width()),
                                                             static_cast<int>(share * window_.height()));
        if (!coarse) {
            return *renderer_;
        }
        coarse_ = std::make_unique<Renderer>(std::move(coarse).value());
        first_look_ = true;
    }
    return *coarse_;
}

void LivePicture::count(double took_s) {
    ++count_;
    slow_s_ += took_s;
    const double now = wall_seconds();
    if (now - begun_s_ >= 1.0) {
        rate_ = count_ / (now - begun_s_);
        begun_s_ = now;
        count_ = 0;
    }
    took_s_.push_back(took_s);
    if (took_s_.size() < least_looked_at || (took_s_.size() < looked_at && slow_s_ < looked_at_s)) {
        return;
    }
    // The median: what a driver builds when something shows for the first time takes seconds once.
    const auto middle = took_s_.begin() + static_cast<std::ptrdiff_t>(took_s_.size() / 2);
    std::nth_element(took_s_.begin(), middle, took_s_.end());
    const double usual_s = *middle;
    took_s_.clear();
    slow_s_ = 0.0;
    if (wishes_.keep_rate && !first_look_ && usual_s > 1.0 / least_rate &&
        size_ + 1 < static_cast<int>(picture_sizes.size())) {
        draw_smaller(usual_s);
    }
    first_look_ = false;  // textures were painted meanwhile
}

/// As much smaller as it takes: pixels cost the time.
void LivePicture::draw_smaller(double usual_s) {
    const double wanted = picture_sizes[static_cast<std::size_t>(size_)] * std::sqrt(1.0 / (least_rate * usual_s));
    while (size_ + 1 < static_cast<int>(picture_sizes.size()) &&
           picture_sizes[static_cast<std::size_t>(size_)] > wanted) {
        ++size_;
    }
    const double share = picture_sizes[static_cast<std::size_t>(size_)];
    Result<Renderer> smaller = Renderer::create_in_window(static_cast<int>(share * window_.width()),
                                                          static_cast<int>(share * window_.height()));
    if (smaller) {
        renderer_ = std::make_unique<Renderer>(std::move(smaller).value());
        coarse_ = nullptr;
    }
    first_look_ = true;
}

/// What the hands have done since this state was made.
void LivePicture::run_ahead(Shown& shown, const std::vector<UserEvent>& after) {
    Hands hands(shown.hands, *shown.stand, holds_);
    for (const UserEvent& event : after) {
        hands.take(event, shown.around);
    }
    // while the clock stands an instrument shows where it waits for the hand
    if (!hands.advance(shown.around, shown.waits ? 0.0 : wishes_.step_s)) {
        return;
    }
    for (const DeviceSample& sample : hands.samples(shown.around, wishes_.step_s)) {
        const auto at = static_cast<std::size_t>(sample.instrument);
        if (at < shown.frame.tools.size() && sample.present) {
            ToolState& tool = shown.frame.tools[at];
            tool.present = true;
            tool.jaw = sample.jaw;
            tool.pose =
                shown.frame.globe ? to_eye(*shown.frame.model->globe, *shown.frame.globe, sample.pose) : sample.pose;
        }
    }
}

}  // namespace rhexis::station
