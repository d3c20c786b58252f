// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/drawing.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace rhexis::station {
namespace {

constexpr double longest_wait_s = 0.02;  ///< for a picture, before the last one is drawn again with newer hands

}  // namespace

Drawing::Drawing(Desk& desk, Window& window, Panels& panels, MappingFile& file, Picture& picture, bool by_hand)
    : desk_(desk), window_(window), panels_(panels), file_(file), picture_(picture), by_hand_(by_hand) {
    window_.let_go();
    thread_ = std::thread([this] { run(); });
}

Drawing::~Drawing() {
    thread_.join();
    window_.draw_here();
}

void Drawing::take(const UserEvent& event) {
    if (panel_asks_) {
        const std::lock_guard lock(mutex_);
        for_panel_.push_back(event);
    } else {
        desk_.post(event);
    }
}

/// Until the trial has ended, or the window has been closed.
void Drawing::run() {
    window_.draw_here();
    std::uint64_t seen = 0;
    bool any = false;
    while (!desk_.ended() && !desk_.closed()) {
        const std::shared_ptr<Shown> shown = desk_.wait_for(any ? std::optional(seen) : std::nullopt, longest_wait_s);
        if (!shown || (any && !by_hand_ && shown->step == seen)) {
            continue;  // there is none, or nobody moves anything before the next one
        }
        any = true;
        draw(*shown);
        seen = shown->step;
        desk_.drawn(seen);
    }
    window_.let_go();
}

void Drawing::draw(Shown& shown) {
    if (!by_hand_) {
        picture_.draw(shown, {});
        return;
    }
    desk_.post(file_.changes(panels_));
    hand_to_panel();
    desk_.post(picture_.draw(shown, desk_.after(shown.events)));
    panel_asks_ = panels_.asks();
    takes_cursor_ = shown.hands.cursor_moves && !shown.waits && !shown.hands.paused;
}

/// What it does not want goes on its way.
void Drawing::hand_to_panel() {
    std::vector<UserEvent> events;
    {
        const std::lock_guard lock(mutex_);
        events = std::exchange(for_panel_, {});
    }
    for (const UserEvent& event : events) {
        if (const std::optional<std::vector<UserEvent>> bound = panels_.captured(event)) {
            desk_.post(*bound);
        } else {
            desk_.post(event);
        }
    }
}

}  // namespace rhexis::station
