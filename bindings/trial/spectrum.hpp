// SPDX-License-Identifier: GPL-3.0-or-later
// How strongly the tip of an instrument swings at each frequency: the spectrum of tremor in a report.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "flow/observation.hpp"

namespace rhexis {

/// Averages windows of two seconds, half over each other, tapered by a cosine and without their straight drift
/// [Welch1967], over all the time in which the tip was in the eye. Frequencies: 1 to 20 Hz, every half.
class Spectra {
public:
    explicit Spectra(const ObservationSchema& schema);

    void add(const Observation& observation);

    /// {"phaco": {"hz": [...], "um_per_sqrt_hz": [...], "windows": 12}}: root of the spectral density of all three
    /// axes. Instruments that were never in the eye for two seconds on end are left out.
    [[nodiscard]] nlohmann::json json() const;

private:
    struct Tip {
        std::string name;
        std::size_t first = 0;  ///< place of x in the row; y and z follow
        std::array<std::vector<double>, 3> window;
        std::vector<double> density;  ///< sum over windows [mm^2/Hz]
        int windows = 0;
    };
    void take_window(Tip& tip) const;

    std::vector<Tip> tips_;
    double last_s_ = 0.0;
    double step_s_ = 0.0;
};

}  // namespace rhexis
