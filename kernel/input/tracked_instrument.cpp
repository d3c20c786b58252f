// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/tracked_instrument.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "input/step_input.hpp"

namespace rhexis {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
/// Without a button; after a leap it is seen again before that.
constexpr std::int64_t put_away_after_us = lost_after_us + 50'000;
constexpr std::int64_t skipped_us = 50'000;  ///< from step to step: the computer was busy with something else

bool in_reach(const Vec3& place) { return place.cwiseAbs().maxCoeff() <= sample_reach_mm; }

}  // namespace

double degrees_between(const Quat& a, const Quat& b) { return degrees * a.angularDistance(b); }

void TrackedInstrument::jaw(std::int64_t time_us, double jaw) {
    if (std::isfinite(jaw)) {
        jaw_.add(time_us, std::clamp(jaw, 0.0, 1.0));
    }
}

void TrackedInstrument::forget_times() {
    poses_.clear();
    present_.forget_times();
    jaw_.forget_times();
}

bool TrackedInstrument::seen_within(std::int64_t time_us, std::int64_t span_us) const {
    const std::optional<PoseTrack::Found> found = poses_.at(time_us);
    return found && found->unseen_us <= span_us;
}

std::optional<Pose> TrackedInstrument::seen(std::int64_t time_us) const {
    return seen_within(time_us, lost_after_us) ? std::optional<Pose>(poses_.at(time_us)->pose) : std::nullopt;
}

bool TrackedInstrument::is_present(std::int64_t time_us, bool inside) const {
    const std::optional<Pose> now = seen(time_us);
    if (now && !in_reach(now->position)) {
        return false;
    }
    const std::optional<double> told = present_.at(time_us, false);
    return told ? *told > 0.5 : inside || seen_within(time_us, put_away_after_us);
}

bool TrackedInstrument::meets(const Pose& held, std::int64_t time_us) const {
    const std::optional<Pose> now = seen(time_us);
    return now && (now->position - held.position).norm() <= meets_within_mm &&
           degrees_between(now->orientation, held.orientation) <= meets_within_deg;
}

void TrackedInstrument::go_on(const DeviceSample& held, std::int64_t time_us) {
    rest_ = {};
    unseen_ = false;
    last_us_ = time_us;
    const std::optional<PoseTrack::Found> found = poses_.at(time_us);
    if (!found) {
        return;
    }
    stretch_ = found->stretch;
    last_seen_ = found->pose.position;
    if (held.present) {
        make_up(held.pose, found->pose, time_us);
    }
}

void TrackedInstrument::make_up(const Pose& held, const Pose& seen, std::int64_t time_us) {
    rest_.off = held.position - seen.position;
    rest_.turned = held.orientation * seen.orientation.conjugate();
    const double seconds =
        std::max(rest_.off.norm() / drawn_mm_s, degrees_between(held.orientation, seen.orientation) / drawn_deg_s);
    rest_.from_us = time_us;
    rest_.to_us = time_us + static_cast<std::int64_t>(1e6 * seconds);
}

Pose TrackedInstrument::with_rest(const Pose& seen, std::int64_t time_us) const {
    if (time_us >= rest_.to_us) {
        return seen;
    }
    const double left = static_cast<double>(rest_.to_us - time_us) / static_cast<double>(rest_.to_us - rest_.from_us);
    const Quat turned = Quat::Identity().slerp(left, rest_.turned);
    return {seen.position + left * rest_.off, (turned * seen.orientation).normalized()};
}

TrackedInstrument::Followed TrackedInstrument::follow(std::int64_t time_us, bool inside, DeviceSample& sample) {
    if (!is_present(time_us, inside && sample.present)) {
        sample.present = false;
        return Followed::yes;
    }
    const std::optional<PoseTrack::Found> found = poses_.at(time_us);
    if (!found || (sample.present && found->stretch != stretch_)) {
        return sample.present ? Followed::lost : Followed::yes;
    }
    if (found->unseen_us > lost_after_us) {
        const bool may_be_put_away = !present_.at(time_us, false) && !inside;
        return sample.present && !may_be_put_away ? Followed::lost : Followed::yes;
    }
    const Vec3 way = found->pose.position - last_seen_;
    if (sample.present && way.norm() > longest_way_mm) {
        return Followed::leapt;
    }
    const bool unseen = found->unseen_us > 0;
    if (!sample.present) {
        rest_ = {};
    } else if ((unseen_ && !unseen) || time_us - last_us_ > skipped_us) {
        make_up(sample.pose, found->pose, time_us);
    }
    sample.present = true;
    sample.pose = with_rest(found->pose, time_us);
    sample.jaw = jaw_.at(time_us, true).value_or(0.0);
    stretch_ = found->stretch;
    last_seen_ = found->pose.position;
    last_us_ = time_us;
    unseen_ = unseen;
    return Followed::yes;
}

}  // namespace rhexis
