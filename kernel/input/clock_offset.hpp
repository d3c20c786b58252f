// SPDX-License-Identifier: GPL-3.0-or-later
// How far a sender's clock is from this computer's, from nothing but when its reports were stamped and when they came.
#pragma once

#include <cstdint>
#include <deque>

namespace rhexis {

/// What came longer ago says nothing: clocks drift apart by up to 50 us a second [us].
inline constexpr std::int64_t clock_window_us = 10'000'000;
/// Stamps that go back by more than this, or come from more than clock_forward_us ahead, are of a clock that was set.
inline constexpr std::int64_t clock_back_us = 100'000;
inline constexpr std::int64_t clock_forward_us = 1'000'000;

/// The least difference of the last ten seconds is of the reports that travelled fastest [Moon1999]: nothing on the way
/// makes one faster. What is left is that fastest way itself, a fraction of a millisecond on a local network.
class ClockOffset {
public:
    /// stamp_us: by the sender's clock; arrival_us: by a clock of this computer that only goes forward. True: the
    /// sender's clock was set, and what was known of the old one is forgotten.
    bool take(std::int64_t stamp_us, std::int64_t arrival_us);
    void restart();

    /// For how long reports have come, within the window [us]; 0: none has.
    [[nodiscard]] std::int64_t heard_for_us() const;
    /// This computer's time less the sender's [us]; only where reports have come.
    [[nodiscard]] std::int64_t offset_us() const;
    /// How much later than the fastest reports come: of all tenths of a second one in twenty is worse [us].
    [[nodiscard]] std::int64_t jitter_us() const;

private:
    /// Of a tenth of a second.
    struct Span {
        std::int64_t begin_us = 0;
        std::int64_t end_us = 0;
        std::int64_t least_us = 0;
        std::int64_t most_us = 0;
    };
    std::deque<Span> spans_;
    std::int64_t newest_stamp_us_ = 0;
};

}  // namespace rhexis
