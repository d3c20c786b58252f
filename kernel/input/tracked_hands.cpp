// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/tracked_hands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/assert.hpp"
#include "flow/microscope.hpp"
#include "math/poses.hpp"

namespace rhexis {
namespace {

constexpr std::int64_t heard_enough_us = 200'000;  ///< before the first offset of the clocks is believed
constexpr double slew = 0.05;                      ///< share of the time that passes, by which the lag may change
constexpr std::int64_t slew_up_to_us = 100'000;    ///< what is farther off is not waited for
constexpr double jitter_room = 1.25;
constexpr std::size_t most_asked = 64;  ///< of the staff, that wait for their moment

bool is_in(const std::vector<bool>& list, std::size_t i) { return i < list.size() && list[i]; }

}  // namespace

std::string text_of(const Standstill& standstill) {
    std::string text = standstill.text;
    const std::size_t at = text.find("%s");
    return at == std::string::npos ? text : text.replace(at, 2, standstill.of);
}

TrackedHands::TrackedHands(TrackedModel model)
    : model_(std::move(model)),
      instruments_(model_.instruments.size()),
      samples_(model_.instruments.size()),
      seen_(model_.instruments.size()) {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        samples_[i].instrument = static_cast<int>(i);
    }
}

std::vector<std::string> TrackedHands::devices() const {
    std::vector<std::string> names = model_.instruments;
    names.emplace_back(pedal_device);
    return names;
}

/// No hand holds the microscope: it is met by nobody, and may be away.
bool TrackedHands::hand_held(std::size_t instrument) const { return model_.instruments[instrument] != microscope_name; }

void TrackedHands::take(const DeviceReport& report, std::int64_t arrival_us) {
    if (const auto* text = std::get_if<TextReport>(&report.what)) {
        if (report.device == staff_device) {
            if (asked_.size() < most_asked) {
                asked_.push_back({report.time_us, text->text});
            }
            return;
        }
        told_ = text->severity == Severity::error ? text->text : told_;
        return;
    }
    if (report.device == pedal_device) {
        const auto* channels = std::get_if<std::vector<double>>(&report.what);
        if (channels != nullptr && !channels->empty() && std::isfinite(channels->front())) {
            pedal_.add(report.time_us, std::clamp(channels->front(), 0.0, 3.0));
        }
        return;
    }
    const auto found = std::find(model_.instruments.begin(), model_.instruments.end(), report.device);
    if (found == model_.instruments.end()) {
        return;
    }
    const auto instrument = static_cast<std::size_t>(found - model_.instruments.begin());
    if (std::holds_alternative<PoseReport>(report.what)) {
        take_pose(instrument, report, arrival_us);
    } else {
        take_value(instrument, report);
    }
}

/// Only poses say how late they are: what is kept until it changes, as buttons are, was stamped when it did.
void TrackedHands::take_pose(std::size_t instrument, const DeviceReport& report, std::int64_t arrival_us) {
    const auto& pose = std::get<PoseReport>(report.what);
    if (pose.sensor != 0) {
        return;
    }
    if (clock_.take(report.time_us, arrival_us)) {
        ++clocks_set_;
        forget_times();
        if (state_ == TrackingState::running) {
            stand({"the clock of the tracking system was set", ""});
        }
    }
    instruments_[instrument].pose(report.time_us, times(model_.registration, {pose.position, pose.turned}));
}

void TrackedHands::take_value(std::size_t instrument, const DeviceReport& report) {
    TrackedInstrument& one = instruments_[instrument];
    if (const auto* button = std::get_if<ButtonReport>(&report.what)) {
        if (button->button == 0) {
            one.present(report.time_us, button->down);
        }
    } else if (const auto* buttons = std::get_if<std::vector<bool>>(&report.what)) {
        if (!buttons->empty()) {
            one.present(report.time_us, buttons->front());
        }
    } else if (const auto* channels = std::get_if<std::vector<double>>(&report.what)) {
        if (!channels->empty()) {
            one.jaw(report.time_us, channels->front());
        }
    }
}

void TrackedHands::link(const std::string& trouble) {
    if (!trouble.empty() && trouble_.empty()) {
        // another server, or the same begun again, may have another clock
        clock_.restart();
        forget_times();
    }
    trouble_ = trouble;
}

void TrackedHands::forget_times() {
    for (TrackedInstrument& one : instruments_) {
        one.forget_times();
    }
    pedal_.forget_times();
    for (Asked& one : asked_) {
        one.time_us = std::numeric_limits<std::int64_t>::min();
    }
    lag_us_.reset();
    std::fill(seen_.begin(), seen_.end(), std::nullopt);
}

void TrackedHands::hold(std::vector<DeviceSample> held, const Standstill& why) {
    RHEXIS_ASSERT(held.size() == samples_.size());
    samples_ = std::move(held);
    if (state_ == TrackingState::running) {
        stand(why);
    }
}

void TrackedHands::stand(const Standstill& why) {
    state_ = TrackingState::standing;
    why_ = why;
}

std::int64_t TrackedHands::delay_us() const {
    if (clock_.heard_for_us() == 0) {
        return least_delay_us;
    }
    std::int64_t interval_us = 0;
    for (const TrackedInstrument& one : instruments_) {
        interval_us = std::max(interval_us, one.interval_us());
    }
    const auto needed_us = static_cast<std::int64_t>(jitter_room * static_cast<double>(clock_.jitter_us()));
    return std::clamp(interval_us + needed_us, least_delay_us, most_delay_us);
}

/// The moment follows this computer's clock; how far behind, changes so slowly that no hand seems to hurry.
void TrackedHands::advance_moment(std::int64_t now_us) {
    const std::int64_t wanted_us = clock_.offset_us() + delay_us();
    const std::int64_t off_us = lag_us_ ? wanted_us - *lag_us_ : 0;
    if (!lag_us_ || std::abs(off_us) > slew_up_to_us) {
        lag_us_ = wanted_us;
    } else {
        const auto most_us = static_cast<std::int64_t>(slew * static_cast<double>(now_us - now_us_));
        *lag_us_ += std::clamp(off_us, -most_us, most_us);
    }
    now_us_ = now_us;
    moment_us_ = now_us - *lag_us_;
}

std::vector<std::string> TrackedHands::take_asked() {
    std::vector<std::string> due;
    std::erase_if(asked_, [&](Asked& one) {
        const bool now = state_ == TrackingState::running && one.time_us <= moment_us_;
        if (now) {
            due.push_back(std::move(one.text));
        }
        return now;
    });
    return due;
}

TrackingState TrackedHands::look(std::int64_t now_us, const std::vector<bool>& inside) {
    const bool waiting = state_ == TrackingState::waiting;
    if (!trouble_.empty()) {
        if (waiting) {
            why_ = {"no link yet: %s", trouble_};
        } else {
            stand({"the link is lost: %s", trouble_});
        }
        return state_;
    }
    if (clock_.heard_for_us() < heard_enough_us) {
        why_ = waiting ? Standstill{"no pose has come yet", ""} : why_;
        return state_;
    }
    advance_moment(now_us);
    for (std::size_t i = 0; i < instruments_.size(); ++i) {
        seen_[i] = instruments_[i].seen(moment_us_);
    }
    pedal_now_ = pedal_.at(moment_us_, true);
    if (!told_.empty()) {
        stand({"the tracking system says: %s", std::exchange(told_, {})});
    } else if (state_ == TrackingState::running) {
        follow(inside);
    } else if (all_met(inside)) {
        go_on(inside);
    } else {
        why_ = to_do(inside);
    }
    return state_;
}

/// The simulation holds it, and it was neither met nor taken away meanwhile.
bool TrackedHands::hinders(std::size_t instrument, const std::vector<bool>& inside) const {
    const DeviceSample& held = samples_[instrument];
    const TrackedInstrument& one = instruments_[instrument];
    return held.present && hand_held(instrument) && one.is_present(moment_us_, is_in(inside, instrument)) &&
           !one.meets(held.pose, moment_us_);
}

bool TrackedHands::all_met(const std::vector<bool>& inside) const {
    for (std::size_t i = 0; i < instruments_.size(); ++i) {
        if (hinders(i, inside)) {
            return false;
        }
    }
    return std::any_of(seen_.begin(), seen_.end(), [](const std::optional<Pose>& pose) { return pose.has_value(); });
}

/// What is to be done before it goes on.
Standstill TrackedHands::to_do(const std::vector<bool>& inside) const {
    for (std::size_t i = 0; i < instruments_.size(); ++i) {
        if (hinders(i, inside)) {
            return {seen_[i] ? "bring %s to where it is shown" : "%s is not seen", model_.instruments[i]};
        }
    }
    return {"no instrument is seen", ""};
}

void TrackedHands::go_on(const std::vector<bool>& inside) {
    state_ = TrackingState::running;
    why_ = {};
    for (std::size_t i = 0; i < instruments_.size(); ++i) {
        instruments_[i].go_on(samples_[i], moment_us_);
    }
    follow(inside);
}

/// All or nothing: where one is lost the others stay too.
void TrackedHands::follow(const std::vector<bool>& inside) {
    std::vector<DeviceSample> now = samples_;
    for (std::size_t i = 0; i < instruments_.size(); ++i) {
        switch (instruments_[i].follow(moment_us_, is_in(inside, i), now[i])) {
            case TrackedInstrument::Followed::lost:
                if (hand_held(i)) {
                    return stand({"%s is lost", model_.instruments[i]});
                }
                now[i].present = false;
                break;
            case TrackedInstrument::Followed::leapt:
                return stand({"%s was seen to leap", model_.instruments[i]});
            default:
                break;
        }
    }
    samples_ = std::move(now);
}

}  // namespace rhexis
