// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/drawing_thread.hpp"

#include <SDL_thread.h>

#include <memory>
#include <optional>
#include <utility>

#include "base/step_back.hpp"
#include "render/image_file.hpp"

namespace rhexis::station {
namespace {

constexpr double longest_wait_s = 0.02;  ///< for a picture, before the last one is drawn again with newer hands

}  // namespace

DrawingThread::DrawingThread(Desk& desk, Window& window, Prepared& prepared, const StationOptions& options,
                             std::string notice)
    : desk_(desk), window_(window), prepared_(prepared), options_(options), notice_(std::move(notice)), thread_([this] {
          run();
          SDL_TLSCleanup();  // what SDL keeps for each thread, it frees for those only that it began itself
      }) {}

DrawingThread::~DrawingThread() {
    desk_.close();
    thread_.join();
}

void DrawingThread::take(const UserEvent& event) {
    if (panel_asks_) {
        const std::lock_guard lock(mutex_);
        for_panel_.push_back(event);
    } else {
        desk_.post(event);
    }
}

void DrawingThread::run() {
    step_back();  // pictures wait for steps, not steps for pictures
    const Status drawable = window_.draw_here();
    Result<FittedRenderer> renderer =
        drawable ? FittedRenderer::create(width_of_eye(window_.width(), options_.stereo), window_.height())
                 : Result<FittedRenderer>(drawable.error());
    if (!renderer) {
        begun_.set_value(renderer.error());
        return;
    }
    {
        Panels panels(window_, std::move(prepared_.words), std::move(prepared_.offers), prepared_.own);
        LivePicture picture(
            window_, panels, std::move(renderer).value(), std::move(*prepared_.holds),
            {options_.stereo, prepared_.ghost ? &*prepared_.ghost : nullptr, !is_stepped(options_), prepared_.step_s});
        begun_.set_value(success());
        if (!notice_.empty()) {
            panels.notice(notice_);
        }
        draw_all(panels, picture);
        finished_.set_value(keep_picture(picture));
    }
    window_.let_go();
}

/// Until the trial has ended, or the window has been closed.
void DrawingThread::draw_all(Panels& panels, LivePicture& picture) {
    MappingFile file(prepared_.mapping_file, prepared_.mapping);
    std::optional<std::uint64_t> seen;
    while (!desk_.ended() && !desk_.closed()) {
        const std::shared_ptr<Shown> shown = desk_.wait_for(seen, longest_wait_s);
        const bool by_hand = operates(options_);
        if (!shown || (!by_hand && shown->step == seen)) {
            continue;  // there is none, or nobody moves anything before the next one
        }
        if (by_hand) {
            draw_by_hand(*shown, file, panels, picture);
        } else {
            picture.draw(*shown, {});
        }
        seen = shown->step;
        desk_.drawn(*seen);
    }
}

void DrawingThread::draw_by_hand(Shown& shown, MappingFile& file, Panels& panels, LivePicture& picture) {
    desk_.post(file.changes(panels));
    hand_to_panel(panels);
    desk_.post(picture.draw(shown, desk_.after(shown.events)));
    panel_asks_ = panels.asks();
    takes_cursor_ = shown.hands.cursor_moves && !shown.waits && !shown.hands.paused;
}

/// What it does not want goes on its way.
void DrawingThread::hand_to_panel(Panels& panels) {
    std::vector<UserEvent> events;
    {
        const std::lock_guard lock(mutex_);
        events = std::exchange(for_panel_, {});
    }
    for (const UserEvent& event : events) {
        if (const std::optional<std::vector<UserEvent>> bound = panels.captured(event)) {
            desk_.post(*bound);
        } else {
            desk_.post(event);
        }
    }
}

/// What the window shows in the end, when all has been done.
Status DrawingThread::keep_picture(LivePicture& picture) {
    desk_.wait_until_ended();
    const std::shared_ptr<Shown> last = desk_.newest();
    if (options_.screenshot.empty() || !last) {
        return success();
    }
    Image image;
    picture.draw(*last, {}, &image);
    return write_png(image, options_.screenshot);
}

}  // namespace rhexis::station
