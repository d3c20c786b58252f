// SPDX-License-Identifier: GPL-3.0-or-later
// One instrument as a tracking system tells of it, and how the simulation follows it: never by a leap.
#pragma once

#include <optional>
#include <string>

#include "flow/device_sample.hpp"
#include "input/pose_track.hpp"

namespace rhexis {

/// A tracked pose has met the one that the simulation holds within these [mm, degrees].
inline constexpr double meets_within_mm = 0.5;
inline constexpr double meets_within_deg = 5.0;

/// How fast it is drawn to where it is seen, over what it was off when it was seen again [mm/s, degrees/s].
inline constexpr double drawn_mm_s = 10.0;
inline constexpr double drawn_deg_s = 90.0;

/// Farthest that a tip comes in one step [mm]: 500 mm/s at 10 ms.
inline constexpr double longest_way_mm = 5.0;

/// Between two orientations, 0 to 180.
double degrees_between(const Quat& a, const Quat& b);

class TrackedInstrument {
public:
    PoseTrack::Taken pose(std::int64_t time_us, const Pose& pose) { return poses_.add(time_us, pose); }
    void present(std::int64_t time_us, bool present) { present_.add(time_us, present ? 1.0 : 0.0); }
    /// 0 to 1; what is beyond counts as that, and what is no number is left out.
    void jaw(std::int64_t time_us, double jaw);
    /// Stamps from here on are of another clock.
    void forget_times();

    /// Where it is seen; none: it is lost, or was never seen.
    [[nodiscard]] std::optional<Pose> seen(std::int64_t time_us) const;
    /// That it is there: as its button says, or, where it has none, while it is seen. inside: of the eye, where it is
    /// there although it is not seen. Out of the reach of samples it is not.
    [[nodiscard]] bool is_present(std::int64_t time_us, bool inside) const;
    [[nodiscard]] bool meets(const Pose& held, std::int64_t time_us) const;
    [[nodiscard]] std::int64_t interval_us() const { return poses_.interval_us(); }

    /// The simulation goes on with it at this moment, from what it holds, which it has met where it was present.
    void go_on(const DeviceSample& held, std::int64_t time_us);

    enum class Followed {
        yes,
        lost,  ///< for longer than an instrument may be: the sample stays as it was
        leapt  ///< farther than a hand comes in a step: likewise
    };
    /// Makes the sample of the step before that of the step that stands for this moment. inside: as above.
    Followed follow(std::int64_t time_us, bool inside, DeviceSample& sample);

private:
    /// What is still to be made up for, shrinking evenly.
    struct Rest {
        Vec3 off = Vec3::Zero();  ///< [mm]
        Quat turned = Quat::Identity();
        std::int64_t from_us = 0;
        std::int64_t to_us = 0;
    };
    [[nodiscard]] bool seen_within(std::int64_t time_us, std::int64_t span_us) const;
    [[nodiscard]] Pose with_rest(const Pose& seen, std::int64_t time_us) const;
    void make_up(const Pose& held, const Pose& seen, std::int64_t time_us);

    PoseTrack poses_;
    ValueTrack present_;
    ValueTrack jaw_;
    Rest rest_;
    int stretch_ = 0;
    std::int64_t last_us_ = 0;
    Vec3 last_seen_ = Vec3::Zero();
    bool unseen_ = false;
};

}  // namespace rhexis
