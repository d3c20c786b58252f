// SPDX-License-Identifier: GPL-3.0-or-later
// How long steps take. Never part of anything that is hashed or recorded.
#pragma once

#include <vector>

#include "session/trial.hpp"
#include "trial/attempt_facts.hpp"

namespace rhexis {

class Timing final : public TrialObserver {
public:
    Status stepped(const TrialStep& step) override;

    [[nodiscard]] Performance performance(double simulated_s) const;

private:
    std::vector<float> wall_ms_;
    double cpu_s_ = 0.0;
    long rollbacks_ = 0;
};

/// What was simulated, and what each part cost.
std::vector<SimulatedPart> simulated_parts(const Session& session);

}  // namespace rhexis
