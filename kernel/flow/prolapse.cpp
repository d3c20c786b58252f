// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/prolapse.hpp"

#include <algorithm>

namespace rhexis {

double unplugged_share(const ProlapseModel& model, const ProlapseState& state) {
    constexpr double filled = 0.5;  // length that fills the tunnel's mouth [mm]
    return 1.0 - model.plugs * std::clamp(state.length / filled, 0.0, 1.0);
}

}  // namespace rhexis
