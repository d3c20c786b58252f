// SPDX-License-Identifier: GPL-3.0-or-later
// What the station knows of hands that a tracking system sees.
#pragma once

#include <optional>
#include <vector>

#include "flow/device_sample.hpp"
#include "input/tracked_hands.hpp"

namespace rhexis::station {

struct TrackedState {
    bool runs = false;                        ///< the clock may go on: what is held has been met
    Standstill why{};                         ///< why it may not
    std::vector<DeviceSample> given{};        ///< by instrument of the stand: what the simulation holds
    std::vector<std::optional<Pose>> seen{};  ///< likewise, while the clock stands: where it is
    Vec3 shift = Vec3::Zero();                ///< of hands in the eye's frame, since the head has moved under them [mm]
};

}  // namespace rhexis::station
