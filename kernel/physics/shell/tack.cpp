// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/tack.hpp"

#include <algorithm>

namespace rhexis {

TackPull tack_at(const Tack& tack, double gap) {
    constexpr double scale = 27.0 / 4.0;  // so that the greatest pull is the traction
    const double s = std::clamp(gap / tack.range, 0.0, 1.0);
    TackPull at;
    at.energy = scale * tack.traction * tack.range * s * s * (0.5 - s * (2.0 / 3.0 - 0.25 * s));
    at.pull = scale * tack.traction * s * (1.0 - s) * (1.0 - s);
    at.slope = gap > 0.0 ? scale * tack.traction / tack.range * (1.0 - s) * (1.0 - 3.0 * s) : 0.0;
    return at;
}

}  // namespace rhexis
