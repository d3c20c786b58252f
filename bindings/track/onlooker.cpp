// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/onlooker.hpp"

#include <chrono>
#include <utility>

#include "base/step_back.hpp"

namespace rhexis::tracking {
namespace {

using LookClock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds look_interval(40);  ///< between two pictures, at least
constexpr std::chrono::milliseconds look_patience(40);  ///< for news, before keys and mouse are looked after again

}  // namespace

Result<std::unique_ptr<Onlooker>> Onlooker::open(const ScreenOptions& options, OpenScreen* open_screen) {
    if (open_screen == nullptr) {
        return std::unique_ptr<Onlooker>();
    }
    std::unique_ptr<Onlooker> onlooker(new Onlooker(options, *open_screen));
    if (const Status begun = onlooker->begun_.get_future().get(); !begun) {
        return begun.error();
    }
    return onlooker;
}

Onlooker::Onlooker(const ScreenOptions& options, OpenScreen& open_screen)
    : options_(options), thread_([this, &open_screen] { run(open_screen); }) {}

Onlooker::~Onlooker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    woken_.notify_one();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void Onlooker::show(Painter painter) {
    {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock) {
            return;
        }
        std::swap(next_, painter);
    }
    wants_ = false;
    woken_.notify_one();
}

Status Onlooker::finish(Painter last) {
    {
        const std::lock_guard lock(mutex_);
        if (last) {
            std::swap(next_, last);
        }
        ending_ = true;
    }
    woken_.notify_one();
    return finished_.get_future().get();
}

void Onlooker::run(OpenScreen& open_screen) {
    step_back();  // and so do the threads that a graphics driver begins
    Result<std::unique_ptr<PictureScreen>> screen = Error{"nothing was opened", "", ""};
    open_screen(options_, screen);
    begun_.set_value(screen ? success() : Status(screen.error()));
    if (!screen) {
        return;
    }
    draw_all(*screen.value());
}

/// Waits a little for what is shown next; whether to go on.
bool Onlooker::take(Painter& painter) {
    std::unique_lock lock(mutex_);
    woken_.wait_for(lock, look_patience, [this] { return next_ || ending_; });
    if (next_) {
        painter = std::exchange(next_, nullptr);
    }
    return !ending_;
}

void Onlooker::draw_all(PictureScreen& screen) {
    Painter painter = [](const ScreenWish&, ScreenMoment&) {};
    ScreenMoment moment;
    ScreenWish wish;
    wants_ = true;
    while (!wish.end && take(painter)) {
        const LookClock::time_point due = LookClock::now() + look_interval;
        painter(wish, moment);
        wish = screen.show(moment);
        std::unique_lock lock(mutex_);
        woken_.wait_until(lock, due, [this] { return ending_; });
        wants_ = true;
    }
    closed_ = wish.end;
    wants_ = false;
    if (options_.screenshot.empty()) {
        finished_.set_value(success());
    } else {
        painter(wish, moment);
        finished_.set_value(screen.keep(moment, options_.screenshot));
    }
}

}  // namespace rhexis::tracking
