// SPDX-License-Identifier: GPL-3.0-or-later
// What one device told of late, so that it can be asked where it was at any moment: poses, and numbers such as a jaw.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "math/types.hpp"

namespace rhexis {

/// No hand is faster [mm/s]: a pose that would need it is a mistake of whoever sees it.
inline constexpr double fastest_hand_mm_s = 500.0;
/// For so long a pose goes on as it moved when no newer one has come; from then on it stays [us].
inline constexpr std::int64_t longest_extrapolation_us = 30'000;
/// An instrument that was not seen for longer is lost [us].
inline constexpr std::int64_t lost_after_us = 200'000;

/// Straight from one to the other, turning evenly about one axis. share: 0 to 1, and beyond 1 as it went on.
Pose between(const Pose& from, const Pose& to, double share);

class PoseTrack {
public:
    enum class Taken {
        followed,  ///< the one before
        began,     ///< the first, or the first after it was lost
        stale,     ///< stamped no later than the one before: left out
        jumped     ///< nobody moves that fast: left out
    };
    /// time_us: by the clock of whoever saw it.
    Taken add(std::int64_t time_us, const Pose& pose);
    void clear() { poses_.clear(); }

    struct Found {
        Pose pose;
        std::int64_t unseen_us = 0;  ///< since the last pose before this moment; 0: there is one after it too
        int stretch = 0;             ///< number of the stretch without a loss that it belongs to
    };
    /// None: nothing is known of so early a moment.
    [[nodiscard]] std::optional<Found> at(std::int64_t time_us) const;

    /// From pose to pose, of late [us]; 0: not known.
    [[nodiscard]] std::int64_t interval_us() const { return interval_us_; }

private:
    struct Stamped {
        std::int64_t time_us = 0;
        Pose pose;
        int stretch = 0;
    };
    [[nodiscard]] Pose gone_on(std::size_t last, std::int64_t time_us) const;

    std::deque<Stamped> poses_;
    int stretch_ = 0;
    std::int64_t interval_us_ = 0;
};

/// A number that is told as it changes.
class ValueTrack {
public:
    /// Left out where it is stamped before the one before.
    void add(std::int64_t time_us, double value);
    /// Stamps from here on are of another clock; what was so is still so.
    void forget_times();
    /// The last that was told by then. evenly: between two that came soon after each other, in proportion. None:
    /// nothing was told yet.
    [[nodiscard]] std::optional<double> at(std::int64_t time_us, bool evenly) const;

private:
    struct Stamped {
        std::int64_t time_us = 0;
        double value = 0.0;
    };
    std::deque<Stamped> values_;
};

}  // namespace rhexis
