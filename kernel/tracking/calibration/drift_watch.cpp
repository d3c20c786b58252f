// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/drift_watch.hpp"

#include <algorithm>

namespace rhexis::tracking {
namespace {

Vec2 median_residual(const std::deque<DriftState::Seen>& seen) {
    Vec2 result;
    std::vector<double> values(seen.size());
    for (int axis = 0; axis < 2; ++axis) {
        std::transform(seen.begin(), seen.end(), values.begin(),
                       [axis](const DriftState::Seen& one) { return one.mean_px[axis]; });
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        result[axis] = *middle;
    }
    return result;
}

}  // namespace

void DriftWatch::add(DriftState& state, double time_s, std::span<const CameraResidual> residuals) const {
    state.cameras.resize(std::max(state.cameras.size(), residuals.size()));
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        if (residuals[i].count > 0 && residuals[i].mean_px.allFinite()) {
            state.cameras[i].push_back({time_s, residuals[i].mean_px});
        }
    }
    for (std::deque<DriftState::Seen>& seen : state.cameras) {
        while (!seen.empty() && seen.front().time_s < time_s - settings_.window_s) {
            seen.pop_front();
        }
    }
}

std::optional<Drift> DriftWatch::drift(const DriftState& state) const {
    Drift worst;
    double most = 0.0;
    double next = 0.0;
    for (std::size_t i = 0; i < state.cameras.size(); ++i) {
        if (state.cameras[i].size() < static_cast<std::size_t>(std::max(1, settings_.fewest_frames))) {
            continue;
        }
        const Vec2 median = median_residual(state.cameras[i]);
        if (median.norm() > most) {
            next = most;
            most = median.norm();
            worst = {static_cast<int>(i), median, false};
        } else {
            next = std::max(next, median.norm());
        }
    }
    worst.alone = most > settings_.alone * next;
    return most > settings_.limit_px ? std::optional<Drift>(worst) : std::nullopt;
}

}  // namespace rhexis::tracking
