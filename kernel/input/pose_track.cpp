// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/pose_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rhexis {
namespace {

constexpr std::int64_t kept_us = 1'000'000;
constexpr std::int64_t velocity_over_us = 20'000;  ///< longer than the noise of two neighbours, shorter than a gesture
constexpr double shortest_s = 0.002;               ///< between two stamps: a sender may bunch them
constexpr double longest_s = 0.01;                 ///< that a hand is granted between two poses, whatever their stamps
constexpr std::int64_t evenly_within_us = 30'000;  ///< told on change only, a value stays until it changes
constexpr double interval_smoothing = 0.05;

double seconds(std::int64_t us) { return 1e-6 * static_cast<double>(us); }

/// Index of the last that is not after a moment; -1: all are.
template <typename List>
std::ptrdiff_t last_by(const List& list, std::int64_t time_us) {
    const auto after = std::upper_bound(list.begin(), list.end(), time_us,
                                        [](std::int64_t time, const auto& one) { return time < one.time_us; });
    return after - list.begin() - 1;
}

}  // namespace

Pose between(const Pose& from, const Pose& to, double share) {
    const Eigen::AngleAxisd turn(Quat(to.orientation * from.orientation.conjugate()));  // the shorter way round
    const Quat orientation = Quat(Eigen::AngleAxisd(share * turn.angle(), turn.axis())) * from.orientation;
    return {from.position + share * (to.position - from.position), orientation.normalized()};
}

PoseTrack::Taken PoseTrack::add(std::int64_t time_us, const Pose& pose) {
    Taken taken = Taken::began;
    if (!poses_.empty()) {
        const Stamped& before = poses_.back();
        if (time_us <= before.time_us) {
            return Taken::stale;
        }
        const std::int64_t since_us = time_us - before.time_us;
        const double granted_s = std::clamp(seconds(since_us), shortest_s, longest_s);
        const bool near = (pose.position - before.pose.position).norm() <= fastest_hand_mm_s * granted_s;
        if (!near && since_us <= lost_after_us) {
            return Taken::jumped;
        }
        if (since_us <= lost_after_us) {
            taken = Taken::followed;
            interval_us_ = interval_us_ == 0
                               ? since_us
                               : interval_us_ + static_cast<std::int64_t>(interval_smoothing *
                                                                          static_cast<double>(since_us - interval_us_));
        }
    }
    stretch_ += taken == Taken::began ? 1 : 0;
    poses_.push_back({time_us, pose, stretch_});
    while (poses_.front().time_us < time_us - kept_us) {
        poses_.pop_front();
    }
    return taken;
}

/// As it moved in the end of its stretch.
Pose PoseTrack::gone_on(std::size_t last, std::int64_t time_us) const {
    const Stamped& newest = poses_[last];
    std::size_t first = last;
    while (first > 0 && poses_[first - 1].stretch == newest.stretch &&
           newest.time_us - poses_[first].time_us < velocity_over_us) {
        --first;
    }
    const std::int64_t span_us = newest.time_us - poses_[first].time_us;
    if (span_us <= 0 || span_us > 2 * velocity_over_us) {
        return newest.pose;
    }
    const std::int64_t ahead_us = std::min(time_us - newest.time_us, longest_extrapolation_us);
    const double share = 1.0 + static_cast<double>(ahead_us) / static_cast<double>(span_us);
    return between(poses_[first].pose, newest.pose, share);
}

std::optional<PoseTrack::Found> PoseTrack::at(std::int64_t time_us) const {
    const std::ptrdiff_t found = last_by(poses_, time_us);
    if (found < 0) {
        return std::nullopt;
    }
    const auto last = static_cast<std::size_t>(found);
    const Stamped& before = poses_[last];
    if (before.time_us == time_us) {
        return Found{before.pose, 0, before.stretch};
    }
    if (last + 1 < poses_.size() && poses_[last + 1].stretch == before.stretch) {
        const Stamped& after = poses_[last + 1];
        const double share =
            static_cast<double>(time_us - before.time_us) / static_cast<double>(after.time_us - before.time_us);
        return Found{between(before.pose, after.pose, share), 0, before.stretch};
    }
    return Found{gone_on(last, time_us), time_us - before.time_us, before.stretch};
}

void ValueTrack::add(std::int64_t time_us, double value) {
    if (!values_.empty() && time_us < values_.back().time_us) {
        return;
    }
    values_.push_back({time_us, value});
    // of those that are long past only the last says what is so
    while (values_.size() > 2 && values_[1].time_us < time_us - kept_us) {
        values_.pop_front();
    }
}

void ValueTrack::forget_times() {
    if (!values_.empty()) {
        values_ = {{std::numeric_limits<std::int64_t>::min() / 2, values_.back().value}};
    }
}

std::optional<double> ValueTrack::at(std::int64_t time_us, bool evenly) const {
    if (values_.empty()) {
        return std::nullopt;
    }
    const std::ptrdiff_t found = last_by(values_, time_us);
    if (found < 0) {
        return values_.front().value;
    }
    const auto last = static_cast<std::size_t>(found);
    const Stamped& before = values_[last];
    if (!evenly || last + 1 == values_.size() || values_[last + 1].time_us - before.time_us > evenly_within_us) {
        return before.value;
    }
    const Stamped& after = values_[last + 1];
    const double share =
        static_cast<double>(time_us - before.time_us) / static_cast<double>(after.time_us - before.time_us);
    return before.value + share * (after.value - before.value);
}

}  // namespace rhexis
