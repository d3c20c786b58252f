// SPDX-License-Identifier: GPL-3.0-or-later
// Shows how far a trial has come.
#pragma once

#include <cstdio>
#include <string>

#include "session/trial.hpp"
#include "trial/progress.hpp"

namespace rhexis {

class TrialProgress final : public TrialObserver {
public:
    /// limit_s: simulated time at which it would be done.
    TrialProgress(std::string label, bool quiet, double limit_s)
        : progress_(std::move(label), quiet), limit_s_(limit_s) {}

    Status stepped(const TrialStep& step) override {
        char note[64];
        std::snprintf(note, sizeof note, "%.1f s simulated", step.session.time_s());
        progress_.show(step.session.time_s() / limit_s_, note);
        return success();
    }

private:
    Progress progress_;
    double limit_s_;
};

}  // namespace rhexis
