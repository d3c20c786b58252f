// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/bodies.hpp"

#include <array>
#include <string>

#include "base/assert.hpp"
#include "tracking/bodies/known_bodies.hpp"

namespace rhexis::tracking::synthetic {

std::vector<MarkerBody> standard_bodies() {
    const std::array<std::string, 3> instruments{"phaco", "forceps", "chopper"};
    Result<std::vector<MarkerBody>> bodies = known_bodies(instruments);
    RHEXIS_ASSERT(bodies.ok());
    for (MarkerBody& body : bodies.value()) {
        body.tip.orientation = Quat::Identity();  // the direction that is measured is the handle's
    }
    return std::move(bodies).value();
}

}  // namespace rhexis::tracking::synthetic
