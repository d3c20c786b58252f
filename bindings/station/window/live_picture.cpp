// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/live_picture.hpp"

#include <epoxy/gl.h>

#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "station/person.hpp"
#include "station/window/read_window.hpp"

namespace rhexis::station {
namespace {

constexpr double coarse_share = 0.5;  ///< of the size of a picture while the eye moves under the microscope
constexpr double still_mm = 0.02;     ///< from picture to picture: half a pixel,
constexpr double turned_mm = 0.4;     ///< and of the camera about the eye, 200 mm away: as much at the eye's wall

}  // namespace

int width_of_eye(int width, Stereo stereo) { return stereo == Stereo::side_by_side ? width / 2 : width; }

LivePicture::LivePicture(Window& window, Panels& panels, FittedRenderer renderer, HoldScript holds,
                         const Wishes& wishes)
    : window_(window),
      panels_(panels),
      wishes_(wishes),
      sharp_(std::move(renderer)),
      holds_(std::move(holds)),
      begun_s_(wall_seconds()) {}

std::vector<UserEvent> LivePicture::draw(Shown& shown, const std::vector<UserEvent>& after, Image* taken) {
    run_ahead(shown, after);
    const double before = wall_seconds();
    const ScreenArea all{0, 0, window_.width(), window_.height()};
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, all.width, all.height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const Camera camera = adjusted(microscope_camera(shown.frame), shown.hands);
    renderer_for(shown.frame, camera, all).show(shown.frame, camera, all, wishes_.stereo);
    std::vector<UserEvent> clicked = panels_.draw(shown, wishes_.ghost, {rate_, size_.share()});
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
    const Sight before =
        std::exchange(sight_, {seen.eye, seen.target, seen.focus_mm, seen.field_mm, frame.eye->pupil_radius});
    return ((sight_.camera - sight_.target) - (before.camera - before.target)).norm() > turned_mm ||
           (sight_.target - before.target).norm() > still_mm ||
           std::abs(sight_.field_mm - before.field_mm) > still_mm ||
           std::abs(sight_.focus_mm - before.focus_mm) > still_mm ||
           std::abs(sight_.pupil_radius - before.pupil_radius) > still_mm;
}

/// While the eye moves under the microscope every place of a picture is new: it is drawn in a fourth of the pixels, and
/// sharp again when it stands.
FittedRenderer& LivePicture::renderer_for(const Frame& frame, const Camera& camera, const ScreenArea& all) {
    const double now_s = wall_seconds();
    const int width = width_of_eye(all.width, wishes_.stereo);
    if (sharp_.fit(width, all.height, size_.share(), now_s)) {
        size_.begin_anew();
    }
    if (!moves(frame, camera) || !wishes_.keep_rate) {
        return sharp_;
    }
    const double share = coarse_share * size_.share();
    if (!coarse_) {
        if (Result<FittedRenderer> made = FittedRenderer::create(width, all.height, share)) {
            coarse_.emplace(std::move(made).value());
            size_.begin_anew();
        }
    } else if (coarse_->fit(width, all.height, share, now_s)) {
        size_.begin_anew();
    }
    return coarse_ ? *coarse_ : sharp_;
}

void LivePicture::count(double took_s) {
    ++count_;
    const double now = wall_seconds();
    if (now - begun_s_ >= 1.0) {
        rate_ = count_ / (now - begun_s_);
        begun_s_ = now;
        count_ = 0;
    }
    if (wishes_.keep_rate) {
        size_.count(took_s);
    }
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
