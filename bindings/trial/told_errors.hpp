// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that a simulation tells of itself while it runs: how deep an implant went into what it touches, and what a
// step left out of balance on it. Nothing finer is needed to know them.
#pragma once

#include <map>
#include <string>

#include "session/trial.hpp"

namespace rhexis {

class ToldErrors final : public TrialObserver {
public:
    Status stepped(const TrialStep& step) override;

    /// The largest so far, by the quantity of a budget (session/accuracy_quantities.hpp); none without an implant.
    [[nodiscard]] const std::map<std::string, double>& largest() const { return largest_; }

private:
    std::map<std::string, double> largest_;
};

}  // namespace rhexis
