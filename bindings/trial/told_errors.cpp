// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/told_errors.hpp"

#include <algorithm>

namespace rhexis {

Status ToldErrors::stepped(const TrialStep& step) {
    for (const ShellStepReport& shell : step.outcome.shells) {
        largest_["overlap"] = std::max(largest_["overlap"], shell.deepest);
        largest_["balance"] = std::max(largest_["balance"], shell.residual);
    }
    return success();
}

}  // namespace rhexis
