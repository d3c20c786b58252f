// SPDX-License-Identifier: GPL-3.0-or-later
// The patient's constants as curves that run over the monitor.
#pragma once

#include <deque>

#include "station/theatre_moment.hpp"

namespace rhexis::station {

/// How each curve goes over one beat of the heart, 0 to 1: about 0 to 1.
double ecg_at(double beat);
double pulse_at(double beat);

/// The last seconds of the heart, sampled evenly.
class Traces {
public:
    static constexpr double span_s = 6.0;
    static constexpr double every_s = 1.0 / 100.0;

    struct Sample {
        double time_s = 0.0;
        double beat = 0.0;
        double systolic_mmhg = 0.0;
        double diastolic_mmhg = 0.0;
    };

    /// Between the moments that came the heart goes on beating as it did.
    void add(double time_s, const Vitals& vitals);
    [[nodiscard]] const std::deque<Sample>& samples() const { return samples_; }

private:
    std::deque<Sample> samples_;
};

}  // namespace rhexis::station
