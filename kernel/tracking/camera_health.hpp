// SPDX-License-Identifier: GPL-3.0-or-later
// Which camera was knocked, from what a tracker says of its sightings.
#pragma once

#include <span>

#include "tracking/calibration/drift_watch.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {

/// A robust pose gives no weight to a camera that the others do not agree with: what it is off by is then what poses of
/// the others make of it.
class CameraHealth {
public:
    explicit CameraHealth(int cameras, const DriftSettings& settings = {}) : watch_(settings), cameras_(cameras) {}

    /// What Tracker::offsets() says after a step; times rise.
    void add(double time_s, std::span<const CameraOffset> offsets);

    /// The camera that is off, and by how much. None: none is, or too little was seen.
    [[nodiscard]] std::optional<Drift> drift() const { return watch_.drift(state_); }

private:
    DriftWatch watch_;
    DriftState state_{};
    int cameras_ = 0;
    std::vector<CameraResidual> residuals_{};
};

}  // namespace rhexis::tracking
