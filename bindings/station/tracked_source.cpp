// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/tracked_source.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "station/asked.hpp"

namespace rhexis::station {
namespace {

constexpr double looks_every_s = 0.01;  ///< while the clock stands: a hand that passes its instrument is not missed
constexpr double patient_s = 1.0;       ///< before it is said for what it waits at first
constexpr double shown_again_mm = 0.02;

bool is_same(const DeviceSample& a, const DeviceSample& b) {
    return a.present == b.present && (!a.present || (a.pose.position == b.pose.position && a.jaw == b.jaw &&
                                                     a.pose.orientation.coeffs() == b.pose.orientation.coeffs()));
}

std::vector<bool> inside_of(const Hands& hands) {
    std::vector<bool> inside(hands.stand().instruments.size());
    for (const HandState& hand : hands.state().hands) {
        if (hand.instrument >= 0) {
            inside[static_cast<std::size_t>(hand.instrument)] = hand.inside;
        }
    }
    return inside;
}

}  // namespace

Result<std::unique_ptr<TrackedSource>> TrackedSource::create(Desk& desk, const TrackedPlace& place,
                                                             TrackedOptions options) {
    Result<vrpn::ServerPlace> server = tracking_place(place.address);
    if (!server) {
        return server.error();
    }
    const Result<Pose> registration = place.registration.empty() ? Pose{} : read_registration(place.registration);
    if (!registration) {
        return registration.error();
    }
    TrackedHands hands({place.instruments, registration.value()});
    auto link = std::make_unique<TrackedLink>(std::move(server).value(), hands.devices(),
                                              std::vector<std::string>{staff_device});
    return std::make_unique<TrackedSource>(desk, std::move(link), std::move(hands), std::move(options));
}

Status TrackedSource::wait(double longest_s) {
    return link_->wait(longest_s) ? success() : Status(Error{link_->collect().trouble, "", ""});
}

TrackedSource::TrackedSource(Desk& desk, std::unique_ptr<TrackedLink> link, TrackedHands hands, TrackedOptions options)
    : options_(std::move(options)),
      clock_(desk, options_.step_s, looks_every_s),
      link_(std::move(link)),
      tracked_(std::move(hands)),
      names_(tracked_.devices()) {
    names_.pop_back();  // the pedal is no instrument
    told_.resize(names_.size());
}

void TrackedSource::hear() {
    const TrackedLink::News news = link_->collect();
    for (const TrackedLink::Arrived& one : news.reports) {
        tracked_.take(one.report, one.arrival_us);
    }
    tracked_.link(news.connected ? "" : news.trouble);
    if (news.connected && !news.trouble.empty() && news.trouble != missing_) {
        say(news.trouble);
    }
    missing_ = news.connected ? news.trouble : "";
}

/// What hands hold and have not met is what the simulation holds.
void TrackedSource::follow(const Hands& hands) {
    const TrackedState& state = *hands.state().tracked;
    const bool paused = hands.state().paused;
    if (!state.runs || paused || away_) {
        const auto count = static_cast<std::ptrdiff_t>(names_.size());
        tracked_.hold({state.given.begin(), state.given.begin() + count});
    }
    if (!paused) {
        tracked_.look(static_cast<std::int64_t>(1e6 * clock_.now_s()), inside_of(hands));
    }
    if (tracked_.state() == TrackingState::running) {
        stands_since_s_ = -1.0;
    } else if (stands_since_s_ < 0.0) {
        stands_since_s_ = wall_seconds();
    }
}

bool TrackedSource::over() const {
    return options_.gives_up_s > 0.0 && stands_since_s_ >= 0.0 &&
           wall_seconds() - stands_since_s_ > options_.gives_up_s;
}

void TrackedSource::say(const std::string& text) {
    if (options_.say) {
        options_.say(text);
    }
}

void TrackedSource::tell_state(const Hands& hands, std::vector<UserEvent>& events) {
    const TrackedState& before = *hands.state().tracked;
    const bool runs = tracked_.state() == TrackingState::running;
    if (runs != before.runs || (!runs && tracked_.why() != before.why)) {
        const Standstill why = runs ? Standstill{} : tracked_.why();
        events.push_back({EventKind::tracking, why.text, runs ? 1.0 : 0.0, 0.0, 0.0, why.of});
        std::fill(told_.begin(), told_.end(), std::nullopt);
    }
    const bool early = tracked_.state() == TrackingState::waiting && wall_seconds() - stands_since_s_ < patient_s;
    const std::string text = runs ? "" : text_of(tracked_.why());
    if (text != said_ && !early) {
        say(runs ? "it goes on" : "the clock stands: " + text);
        said_ = text;
    }
}

void TrackedSource::tell_samples(const Hands& hands, std::vector<UserEvent>& events) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const DeviceSample& sample = tracked_.samples()[i];
        if (!is_same(sample, hands.state().tracked->given[i])) {
            events.push_back({EventKind::tracked, names_[i], sample.present ? 1.0 : 0.0, 0.0, 0.0, "", sample});
        }
    }
    for (const std::string& text : tracked_.take_asked()) {
        const Result<Asked> asked = what_is_asked(hands.stand(), text);
        if (!asked) {
            say(asked.error().text());
        }
        events.push_back({EventKind::asked, text});  // the window says it too where it cannot be
    }
    if (tracked_.pedal() && *tracked_.pedal() != hands.state().pedal) {
        events.push_back({EventKind::tracked, pedal_device, *tracked_.pedal()});
    }
}

/// So that a hand can be led to what it has to meet.
void TrackedSource::tell_seen(std::vector<UserEvent>& events) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const std::optional<Pose>& seen = tracked_.seen()[i];
        const bool same = seen ? told_[i] && (seen->position - *told_[i]).norm() < shown_again_mm : !told_[i];
        if (same) {
            continue;
        }
        DeviceSample sample;
        sample.pose = seen.value_or(Pose{});
        events.push_back({EventKind::tracked, names_[i], seen ? 1.0 : 0.0, 0.0, 0.0, "", sample});
        told_[i] = seen ? std::optional<Vec3>(seen->position) : std::nullopt;
    }
}

Result<std::vector<UserEvent>> TrackedSource::take(std::uint64_t step, bool waits, const Hands& hands,
                                                   const Surroundings& around, const Session& session) {
    Result<std::vector<UserEvent>> taken = clock_.take(step, waits, hands, around, session);
    if (!taken) {
        return taken;
    }
    RHEXIS_ASSERT(hands.state().tracked.has_value());
    std::vector<UserEvent>& events = taken.value();
    // without a desk nobody could say that it goes on: meeting what is held is enough
    away_ = !options_.desk && !events.empty();
    if (!options_.desk) {
        events.clear();
    }
    hear();
    follow(hands);
    if (over()) {
        return std::vector<UserEvent>{};
    }
    tell_state(hands, events);
    if (tracked_.state() == TrackingState::running) {
        tell_samples(hands, events);
    } else {
        tell_seen(events);
    }
    return taken;
}

}  // namespace rhexis::station
