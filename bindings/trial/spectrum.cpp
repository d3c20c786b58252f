// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace rhexis {
namespace {

constexpr double window_s = 2.0;
constexpr double first_hz = 1.0;
constexpr double spacing_hz = 0.5;
constexpr int frequencies = 39;

/// Without mean and straight drift, tapered.
std::vector<double> prepared(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    double mean = 0.0;
    double slope = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        mean += values[i] / n;
        slope += values[i] * (static_cast<double>(i) - 0.5 * (n - 1.0));
    }
    slope *= 12.0 / (n * (n * n - 1.0));
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double at = static_cast<double>(i);
        const double taper = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (at + 0.5) / n);
        result[i] = taper * (values[i] - mean - slope * (at - 0.5 * (n - 1.0)));
    }
    return result;
}

/// One-sided spectral density [mm^2/Hz]. The mean square of the taper is 3/8.
double density_at(const std::vector<double>& values, double hz, double step_s) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * hz * step_s);
    std::complex<double> phase = 1.0;
    std::complex<double> sum = 0.0;
    for (const double value : values) {
        sum += value * phase;
        phase *= turn;
    }
    return 2.0 * std::norm(sum) * step_s / (0.375 * static_cast<double>(values.size()));
}

double hundredths(double value) { return std::round(100.0 * value) / 100.0; }

}  // namespace

Spectra::Spectra(const ObservationSchema& schema) {
    const std::string ending = ".tip_x_mm";
    for (std::size_t i = 0; i + 2 < schema.size(); ++i) {
        if (schema[i].name.ends_with(ending)) {
            tips_.push_back({schema[i].name.substr(0, schema[i].name.size() - ending.size()), i, {}, {}, 0});
        }
    }
}

void Spectra::add(const Observation& observation) {
    step_s_ = observation.time_s - last_s_;
    last_s_ = observation.time_s;
    if (step_s_ <= 0.0 || step_s_ > 0.02) {
        return;
    }
    const std::size_t length = static_cast<std::size_t>(std::lround(window_s / step_s_));
    for (Tip& tip : tips_) {
        const bool present = std::isfinite(observation.values[tip.first]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (present) {
                tip.window[axis].push_back(observation.values[tip.first + axis]);
            } else {
                tip.window[axis].clear();
            }
        }
        if (tip.window[0].size() >= length) {
            take_window(tip);
        }
    }
}

void Spectra::take_window(Tip& tip) const {
    tip.density.resize(frequencies, 0.0);
    for (std::vector<double>& axis : tip.window) {
        const std::vector<double> values = prepared(axis);
        for (int i = 0; i < frequencies; ++i) {
            tip.density[static_cast<std::size_t>(i)] += density_at(values, first_hz + spacing_hz * i, step_s_);
        }
        axis.erase(axis.begin(), axis.begin() + static_cast<std::ptrdiff_t>(axis.size() / 2));
    }
    ++tip.windows;
}

nlohmann::json Spectra::json() const {
    nlohmann::json result = nlohmann::json::object();
    for (const Tip& tip : tips_) {
        if (tip.windows == 0) {
            continue;
        }
        nlohmann::json hz = nlohmann::json::array();
        nlohmann::json um = nlohmann::json::array();
        for (int i = 0; i < frequencies; ++i) {
            hz.push_back(first_hz + spacing_hz * i);
            um.push_back(hundredths(1e3 * std::sqrt(tip.density[static_cast<std::size_t>(i)] / tip.windows)));
        }
        result[tip.name] = {{"hz", hz}, {"um_per_sqrt_hz", um}, {"windows", tip.windows}};
    }
    return result;
}

}  // namespace rhexis
