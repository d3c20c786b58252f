// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/clock_offset.hpp"

#include <algorithm>
#include <vector>

#include "base/assert.hpp"

namespace rhexis {
namespace {

constexpr std::int64_t span_us = 100'000;
constexpr double worse_share = 0.05;

}  // namespace

bool ClockOffset::take(std::int64_t stamp_us, std::int64_t arrival_us) {
    const std::int64_t difference_us = arrival_us - stamp_us;
    const bool set = !spans_.empty() &&
                     (stamp_us < newest_stamp_us_ - clock_back_us || difference_us < offset_us() - clock_forward_us);
    if (set) {
        restart();
    }
    newest_stamp_us_ = spans_.empty() ? stamp_us : std::max(newest_stamp_us_, stamp_us);
    if (spans_.empty() || arrival_us >= spans_.back().begin_us + span_us) {
        spans_.push_back({arrival_us, arrival_us, difference_us, difference_us});
    } else {
        Span& span = spans_.back();
        span.end_us = arrival_us;
        span.least_us = std::min(span.least_us, difference_us);
        span.most_us = std::max(span.most_us, difference_us);
    }
    while (spans_.front().begin_us < arrival_us - clock_window_us) {
        spans_.pop_front();
    }
    return set;
}

void ClockOffset::restart() { spans_.clear(); }

std::int64_t ClockOffset::heard_for_us() const {
    return spans_.empty() ? 0 : spans_.back().end_us - spans_.front().begin_us;
}

std::int64_t ClockOffset::offset_us() const {
    RHEXIS_ASSERT(!spans_.empty());
    return std::min_element(spans_.begin(), spans_.end(),
                            [](const Span& a, const Span& b) { return a.least_us < b.least_us; })
        ->least_us;
}

std::int64_t ClockOffset::jitter_us() const {
    RHEXIS_ASSERT(!spans_.empty());
    std::vector<std::int64_t> most;
    for (const Span& span : spans_) {
        most.push_back(span.most_us);
    }
    const auto worse = static_cast<std::ptrdiff_t>(worse_share * static_cast<double>(most.size()));
    const auto at = most.end() - 1 - worse;
    std::nth_element(most.begin(), at, most.end());
    return *at - offset_us();
}

}  // namespace rhexis
