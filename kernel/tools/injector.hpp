// SPDX-License-Identifier: GPL-3.0-or-later
// An injector: a cartridge in which a folded implant lies, and a plunger that pushes it through a narrower nozzle.
#pragma once

#include "base/result.hpp"
#include "flow/tool.hpp"

namespace rhexis {

inline constexpr const char* injector_name = "injector";

/// Inner diameters [mm]; friction: of the wall, Coulomb coefficient.
struct InjectorShape {
    double chamber = 2.8;   ///< where the implant is laid: 1 to 4
    double nozzle = 2.8;    ///< at the tip: 1 to that of the chamber
    double friction = 0.1;  ///< 0 to 2
    bool tucked = true;     ///< the implant's haptics lie on its optic; false: before and behind it, which takes room
    bool inverted =
        false;           ///< folded lying on its front, and held turned by half a turn: tucked haptics come out behind
    double push = 30.0;  ///< most that a hand presses the plunger with [N], 1 to 100; 5 to 30 are spoken of
};

/// Fails with the field and what is allowed.
Status check_injector(const InjectorShape& shape);

/// Its tip at the origin, the bore along z, which points back to the hand. The shape must pass check_injector.
ToolModel injector(const InjectorShape& shape);

}  // namespace rhexis
