// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/series.hpp"

#include <cmath>

namespace rhexis {
namespace {

/// Five significant digits are more than a chart shows and keep the file small.
nlohmann::json rounded(double value) {
    if (!std::isfinite(value)) {
        return nullptr;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return std::strtod(text, nullptr);
}

}  // namespace

void Series::add(const Observation& observation) {
    spectra_.add(observation);
    if (seen_++ % stride_ != 0) {
        return;
    }
    kept_.push_back(observation);
    if (kept_.size() < most) {
        return;
    }
    std::vector<Observation> half;
    for (std::size_t i = 0; i < kept_.size(); i += 2) {
        half.push_back(std::move(kept_[i]));
    }
    kept_ = std::move(half);
    stride_ *= 2;
}

nlohmann::json Series::json() const {
    nlohmann::json times = nlohmann::json::array();
    for (const Observation& observation : kept_) {
        times.push_back(rounded(observation.time_s));
    }
    nlohmann::json measures = nlohmann::json::object();
    for (std::size_t i = 0; i < schema_.size(); ++i) {
        nlohmann::json values = nlohmann::json::array();
        for (const Observation& observation : kept_) {
            values.push_back(rounded(observation.values[i]));
        }
        measures[schema_[i].name] = {{"unit", schema_[i].unit}, {"meaning", schema_[i].meaning}, {"values", values}};
    }
    return {{"schema", 1}, {"time_s", times}, {"measures", measures}, {"spectra", spectra_.json()}};
}

}  // namespace rhexis
