// SPDX-License-Identifier: GPL-3.0-or-later
// How long steps take. Never part of anything that is hashed or recorded.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "session/trial.hpp"

namespace rhexis {

class Timing final : public TrialObserver {
public:
    Status stepped(const TrialStep& step) override;

    /// {"steps","cpu_s_per_s","mean_step_ms","p99_step_ms","worst_step_ms","rollbacks"} of report.json; times of the
    /// kernel's step, all threads, without scripts and pictures.
    [[nodiscard]] nlohmann::json performance(double simulated_s) const;

private:
    std::vector<float> wall_ms_;
    double cpu_s_ = 0.0;
    long rollbacks_ = 0;
};

/// [{"part","elements","cpu_s"}] of report.json: what was simulated, and what each part cost.
nlohmann::json simulated_parts(const Session& session);

}  // namespace rhexis
