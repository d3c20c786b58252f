// SPDX-License-Identifier: GPL-3.0-or-later
// Which of an implant's triangles and nodes are what.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace rhexis {

enum class ImplantPart : std::uint8_t { optic, upper_haptic, lower_haptic };

/// The upper haptic first. Folded into a cartridge that one lies ahead: it comes into the eye first.
struct ImplantParts {
    std::vector<ImplantPart> part;         ///< per triangle
    std::array<int, 2> tip{};              ///< node at the end of either haptic
    std::array<std::vector<int>, 2> root;  ///< nodes that either shares with the optic
};

}  // namespace rhexis
