// SPDX-License-Identifier: GPL-3.0-or-later
// What a theatre sounds like: the phaco machine tells by ear what its panel tells by eye, and tissue that is pressed
// hums, since no hand feels it here.
#pragma once

#include <atomic>
#include <span>

#include "station/theatre_moment.hpp"

namespace rhexis::station {

// Pitches [Hz]: each voice has a range of its own, so that one is not taken for the other.
inline constexpr double ultrasound_low_hz = 220.0;   ///< at no power
inline constexpr double ultrasound_high_hz = 440.0;  ///< at full power
inline constexpr double vacuum_low_hz = 500.0;       ///< at no vacuum
inline constexpr double vacuum_high_hz = 1000.0;     ///< at 650 mmHg
inline constexpr double alarm_first_hz = 1400.0;     ///< of a chamber that empties, in turn
inline constexpr double alarm_second_hz = 1750.0;
inline constexpr double force_hz = 110.0;

double ultrasound_hz(double power);
double vacuum_hz(double vacuum_mmhg);

/// Told on one thread, mixed on another.
class Voices {
public:
    explicit Voices(double samples_per_s) : samples_per_s_(samples_per_s) {}

    /// force_mN: the greatest of all hands.
    void tell(const MachinePanel& machine, double force_mN);
    /// The clock stands, or it is over.
    void hush();

    /// The next samples, -1 to 1, one channel. Pitch and loudness glide to what was told last.
    void mix(std::span<float> samples);

private:
    struct Voice {
        double phase = 0.0;     ///< turns
        double loudness = 0.0;  ///< as it is now
        double hz = 0.0;
    };

    double next(Voice& voice, double hz, double loudness) const;

    double samples_per_s_;
    std::atomic<double> power_ = 0.0;
    std::atomic<double> vacuum_mmhg_ = 0.0;
    std::atomic<bool> aspirates_ = false;
    std::atomic<bool> empties_ = false;
    std::atomic<double> force_mN_ = 0.0;
    Voice ultrasound_, vacuum_, alarm_, force_;
    double alarm_left_s_ = 0.0;
    double alarm_s_ = 0.0;
};

}  // namespace rhexis::station
