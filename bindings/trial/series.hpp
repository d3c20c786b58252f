// SPDX-License-Identifier: GPL-3.0-or-later
// The measures over time, thinned for charts: series.json of a run.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "session/trial.hpp"
#include "trial/spectrum.hpp"

namespace rhexis {

class Series final : public TrialObserver {
public:
    explicit Series(const ObservationSchema& schema) : schema_(schema), spectra_(schema) {}

    Status begun(Timeline& timeline) override {
        add(timeline.observation());
        return success();
    }
    Status stepped(const TrialStep& step) override {
        add(step.session.observation());
        return success();
    }
    /// Takes every step's observation and keeps some of them, evenly spread: never more than `most`.
    void add(const Observation& observation);

    /// {"schema": 1, "time_s": [...], "measures": {"groove.depth_mm": {"unit": "mm", "meaning": "...",
    /// "values": [...]}}, "spectra": see Spectra}; null where a measure was not defined.
    [[nodiscard]] nlohmann::json json() const;

private:
    static constexpr std::size_t most = 1200;

    ObservationSchema schema_;
    Spectra spectra_;
    std::vector<Observation> kept_;
    std::size_t stride_ = 1;
    std::size_t seen_ = 0;
};

}  // namespace rhexis
