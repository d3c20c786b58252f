// SPDX-License-Identifier: GPL-3.0-or-later
// Pitch by the power at a frequency (Goertzel), not by how the samples were made.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "station/voices.hpp"

using namespace rhexis::station;

namespace {

constexpr double samples_per_s = 44100.0;

std::vector<float> mixed(Voices& voices, double seconds) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * samples_per_s));
    voices.mix(samples);
    return samples;
}

double power_at(const std::vector<float>& samples, double hz) {
    const double turn = 2.0 * std::numbers::pi * hz / samples_per_s;
    double re = 0.0;
    double im = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        re += samples[i] * std::cos(turn * static_cast<double>(i));
        im += samples[i] * std::sin(turn * static_cast<double>(i));
    }
    const double n = static_cast<double>(samples.size());
    return 4.0 * (re * re + im * im) / (n * n);
}

/// The strongest pitch in a range.
double pitch(const std::vector<float>& samples, double from_hz, double to_hz) {
    double best = from_hz;
    for (double hz = from_hz; hz <= to_hz; hz += 1.0) {
        best = power_at(samples, hz) > power_at(samples, best) ? hz : best;
    }
    return best;
}

double loudness(const std::vector<float>& samples) {
    double most = 0.0;
    for (const float sample : samples) {
        most = std::max(most, std::abs(static_cast<double>(sample)));
    }
    return most;
}

MachinePanel a_panel(double pedal, double power, double vacuum_mmhg) {
    MachinePanel panel;
    panel.there = true;
    panel.pedal = pedal;
    panel.power = power;
    panel.vacuum_mmhg = vacuum_mmhg;
    return panel;
}

}  // namespace

TEST_CASE("ultrasound and vacuum are heard by their pitch, and nothing is heard of a foot that is up") {
    Voices voices(samples_per_s);
    CHECK(loudness(mixed(voices, 0.1)) == 0.0);
    for (const double power : {0.2, 0.7, 1.0}) {
        for (const double vacuum : {50.0, 300.0, 600.0}) {
            voices.tell(a_panel(3.0, power, vacuum), 0.0);
            mixed(voices, 0.5);  // it glides there
            const std::vector<float> heard = mixed(voices, 0.5);
            CHECK(std::abs(pitch(heard, 150.0, 480.0) - (220.0 + 220.0 * power)) <= 1.0);
            CHECK(std::abs(pitch(heard, 490.0, 1100.0) - (500.0 + 500.0 * vacuum / 650.0)) <= 1.0);
            CHECK(loudness(heard) < 1.0);
        }
    }
    voices.hush();
    mixed(voices, 0.5);
    CHECK(loudness(mixed(voices, 0.2)) < 1e-4);
}

TEST_CASE("a chamber that empties sounds the alarm, with two pitches in turn, and one that stays deep does not") {
    Voices voices(samples_per_s);
    MachinePanel panel = a_panel(2.0, 0.0, 300.0);
    panel.depth_lost = 0.2;
    voices.tell(panel, 0.0);
    std::vector<float> heard = mixed(voices, 1.0);
    CHECK(power_at(heard, alarm_first_hz) < 1e-5);
    panel.depth_lost = 0.4;
    voices.tell(panel, 0.0);
    int first = 0;
    int second = 0;
    for (int i = 0; i < 20; ++i) {
        heard = mixed(voices, 0.05);
        first += power_at(heard, alarm_first_hz) > 0.01 ? 1 : 0;
        second += power_at(heard, alarm_second_hz) > 0.01 ? 1 : 0;
    }
    CHECK(first >= 6);
    CHECK(second >= 6);
    panel.depth_lost = 0.0;
    voices.tell(panel, 0.0);
    mixed(voices, 2.0);
    CHECK(power_at(mixed(voices, 1.0), alarm_first_hz) < 1e-5);
}

TEST_CASE("tissue that is pressed hums the louder the harder") {
    Voices voices(samples_per_s);
    double before = -1.0;
    for (const double force_mN : {0.0, 5.0, 15.0, 40.0}) {
        voices.tell(MachinePanel{}, force_mN);
        mixed(voices, 0.3);
        const double heard = power_at(mixed(voices, 0.5), force_hz);
        CHECK(heard > before);
        before = heard;
    }
}

TEST_CASE("no jump from sample to sample clicks") {
    Voices voices(samples_per_s);
    float last = 0.0F;
    float most = 0.0F;
    for (int i = 0; i < 40; ++i) {
        voices.tell(a_panel(i % 2 == 0 ? 3.0 : 1.0, i % 2 == 0 ? 1.0 : 0.0, 600.0), i % 3 == 0 ? 40.0 : 0.0);
        for (const float sample : mixed(voices, 0.02)) {
            most = std::max(most, std::abs(sample - last));
            last = sample;
        }
    }
    CHECK(most < 0.08F);
}
