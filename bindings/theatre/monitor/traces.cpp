// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/monitor/traces.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::station {
namespace {

double bump(double beat, double at, double width, double height) {
    const double away = (beat - at) / width;
    return height * std::exp(-0.5 * away * away);
}

}  // namespace

double ecg_at(double beat) {  // P, Q, R, S, T
    return 0.25 + bump(beat, 0.18, 0.025, 0.10) - bump(beat, 0.285, 0.008, 0.12) + bump(beat, 0.31, 0.010, 0.75) -
           bump(beat, 0.335, 0.009, 0.20) + bump(beat, 0.55, 0.040, 0.18);
}

double pulse_at(double beat) {  // the pressure's rise comes after the heart's; a notch where the valve shuts
    const double since = beat < 0.38 ? beat + 1.0 - 0.38 : beat - 0.38;
    return std::exp(-2.2 * since) * (1.0 - std::exp(-since / 0.04)) + bump(since, 0.42, 0.04, 0.08);
}

void Traces::add(double time_s, const Vitals& vitals) {
    if (!samples_.empty() && time_s < samples_.back().time_s) {
        samples_.clear();  // the attempt went back, or another one began
    }
    const double beats_per_s = vitals.heart_per_min / 60.0;
    double at = samples_.empty() ? time_s : samples_.back().time_s + every_s;
    at = std::max(at, time_s - span_s);
    for (; at <= time_s; at += every_s) {
        double beat = vitals.beat - (time_s - at) * beats_per_s;
        beat -= std::floor(beat);
        samples_.push_back({at, beat, vitals.systolic_mmhg, vitals.diastolic_mmhg});
    }
    while (!samples_.empty() && samples_.front().time_s < time_s - span_s) {
        samples_.pop_front();
    }
}

}  // namespace rhexis::station
