// SPDX-License-Identifier: GPL-3.0-or-later
// An exercise that is edited while it runs: read again between two of its steps.
#pragma once

#include <nlohmann/json.hpp>

#include "lua/exercise_host.hpp"

namespace rhexis {

class HotReload final : public TrialObserver {
public:
    explicit HotReload(ExerciseHost& host) : host_(host) {}

    /// Takes up changed files, or says why not and lets the exercise go on with what there is.
    Status look(Moment& moment) override;

    /// [{"time_s", "sha256", "refused": why, where it was}]
    [[nodiscard]] const nlohmann::json& reloads() const { return reloads_; }

private:
    ExerciseHost& host_;
    nlohmann::json reloads_ = nlohmann::json::array();
};

}  // namespace rhexis
