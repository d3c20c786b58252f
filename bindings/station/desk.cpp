// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/desk.hpp"

#include <algorithm>
#include <chrono>

#include "base/clock.hpp"

namespace rhexis::station {
namespace {

std::chrono::duration<double> seconds(double value) { return std::chrono::duration<double>(std::max(0.0, value)); }

}  // namespace

void Desk::post(const UserEvent& event) {
    const std::lock_guard lock(mutex_);
    events_.push_back({event, ++last_number_});
    recent_.push_back(events_.back());
    posted_.notify_all();
}

void Desk::post(const std::vector<UserEvent>& events) {
    for (const UserEvent& event : events) {
        post(event);
    }
}

std::vector<UserEvent> Desk::after(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    while (!recent_.empty() && recent_.front().number <= number) {
        recent_.pop_front();
    }
    std::vector<UserEvent> events;
    for (const PostedEvent& posted : recent_) {
        events.push_back(posted.event);
    }
    return events;
}

bool Desk::closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
}

std::shared_ptr<Shown> Desk::newest() const {
    const std::lock_guard lock(mutex_);
    taken_ = true;
    return newest_;
}

std::shared_ptr<Shown> Desk::wait_for(const std::optional<std::uint64_t>& step, double longest_s) {
    std::unique_lock lock(mutex_);
    shown_.wait_for(lock, seconds(longest_s), [&] { return ended_ || (newest_ && (!step || newest_->step > *step)); });
    taken_ = true;
    return newest_;
}

void Desk::drawn(std::uint64_t step) {
    const std::lock_guard lock(mutex_);
    drawn_step_ = step;
    last_drawn_s_ = wall_seconds();
    first_drawn_s_ = any_drawn_ ? first_drawn_s_ : last_drawn_s_;
    any_drawn_ = true;
    ++pictures_;
    drawn_.notify_all();
}

bool Desk::ended() const {
    const std::lock_guard lock(mutex_);
    return ended_;
}

void Desk::wait_until_ended() {
    std::unique_lock lock(mutex_);
    shown_.wait(lock, [&] { return ended_; });
}

void Desk::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    drawn_.notify_all();
}

std::vector<PostedEvent> Desk::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(events_, {});
}

void Desk::wait_for_event(double until_s) {
    std::unique_lock lock(mutex_);
    posted_.wait_for(lock, seconds(until_s - wall_seconds()), [&] { return !events_.empty(); });
}

void Desk::show(std::shared_ptr<Shown> shown) {
    const std::lock_guard lock(mutex_);
    newest_ = std::move(shown);
    taken_ = false;
    shown_.notify_all();
}

bool Desk::wants_picture() const {
    const std::lock_guard lock(mutex_);
    return taken_;
}

double Desk::pictures_per_s() const {
    const std::lock_guard lock(mutex_);
    const double span = last_drawn_s_ - first_drawn_s_;
    return span > 0.0 ? static_cast<double>(pictures_ - 1) / span : 0.0;
}

void Desk::wait_until_drawn(std::uint64_t step) {
    std::unique_lock lock(mutex_);
    drawn_.wait(lock, [&] { return closed_ || (any_drawn_ && drawn_step_ >= step); });
}

void Desk::hear(const Heard& heard) {
    const std::lock_guard lock(mutex_);
    heard_ = heard;
}

Heard Desk::heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
}

void Desk::end() {
    const std::lock_guard lock(mutex_);
    heard_.silent = true;
    ended_ = true;
    shown_.notify_all();
}

}  // namespace rhexis::station
