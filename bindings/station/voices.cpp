// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/voices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis::station {
namespace {

constexpr double most_vacuum_mmhg = 650.0;
constexpr double aspirates_from = 1.95;  ///< position of the pedal
constexpr double surge_share = 0.3;      ///< of the chamber's depth lost within a second, as the surge event has it
constexpr double alarm_lasts_s = 1.5;    ///< after the last sign
constexpr double alarm_turn_s = 0.25;    ///< each of its two pitches
constexpr double silent_below_mN = 2.0;
constexpr double loudest_from_mN = 40.0;
constexpr double glide_s = 0.03;  ///< of pitch and loudness: none jumps, which would click

// Loudness: all together stay below 1.
constexpr double ultrasound_loud = 0.22;
constexpr double vacuum_loud = 0.12;
constexpr double alarm_loud = 0.3;
constexpr double force_loud = 0.2;

}  // namespace

double ultrasound_hz(double power) {
    return ultrasound_low_hz + (ultrasound_high_hz - ultrasound_low_hz) * std::clamp(power, 0.0, 1.0);
}

double vacuum_hz(double vacuum_mmhg) {
    return vacuum_low_hz + (vacuum_high_hz - vacuum_low_hz) * std::clamp(vacuum_mmhg / most_vacuum_mmhg, 0.0, 1.0);
}

void Voices::tell(const MachinePanel& machine, double force_mN) {
    power_ = std::max(0.0, machine.power);
    vacuum_mmhg_ = std::max(0.0, machine.vacuum_mmhg);
    aspirates_ = machine.there && machine.pedal >= aspirates_from;
    empties_ = machine.there && machine.depth_lost > surge_share;
    force_mN_ = force_mN;
}

void Voices::hush() { tell(MachinePanel{}, 0.0); }

double Voices::next(Voice& voice, double hz, double loudness) const {
    const double glide = 1.0 - std::exp(-1.0 / (glide_s * samples_per_s_));
    voice.hz = voice.hz == 0.0 || voice.loudness < 1e-4 ? hz : voice.hz + glide * (hz - voice.hz);
    voice.loudness += glide * (loudness - voice.loudness);
    voice.phase += voice.hz / samples_per_s_;
    voice.phase -= std::floor(voice.phase);
    return voice.loudness * std::sin(2.0 * std::numbers::pi * voice.phase);
}

void Voices::mix(std::span<float> samples) {
    const double power = power_;
    const double vacuum_mmhg = vacuum_mmhg_;
    const double pressed = (force_mN_ - silent_below_mN) / (loudest_from_mN - silent_below_mN);
    alarm_left_s_ = empties_ ? alarm_lasts_s : alarm_left_s_;
    for (float& sample : samples) {
        alarm_left_s_ = std::max(0.0, alarm_left_s_ - 1.0 / samples_per_s_);
        alarm_s_ += 1.0 / samples_per_s_;
        const bool first = std::fmod(alarm_s_, 2.0 * alarm_turn_s) < alarm_turn_s;
        const double sum =
            next(ultrasound_, power > 0.0 ? ultrasound_hz(power) : ultrasound_.hz,
                 power > 0.0 ? ultrasound_loud : 0.0) +
            next(vacuum_, vacuum_hz(vacuum_mmhg), aspirates_ ? vacuum_loud : 0.0) +
            next(alarm_, first ? alarm_first_hz : alarm_second_hz, alarm_left_s_ > 0.0 ? alarm_loud : 0.0) +
            next(force_, force_hz, force_loud * std::clamp(pressed, 0.0, 1.0));
        sample = static_cast<float>(sum);
    }
}

}  // namespace rhexis::station
