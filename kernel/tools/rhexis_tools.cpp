// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/rhexis_tools.hpp"

namespace rhexis {
namespace {

/// The last part of an instrument is bent down at a right angle to its shaft, which comes from the wound: along -y and
/// up. The tip is the origin, so that a hand that holds the shaft level with the wound has its point straight down.
constexpr double shaft_fall = 0.1;  ///< up per length towards the hand

Vec3 towards_hand() { return Vec3(0.0, -1.0, shaft_fall).normalized(); }

constexpr double shaft_length = 26.0;
constexpr double handle_length = 110.0;

/// A bent end of a length and radii, a shaft from there to the hand, and a handle.
ToolModel bent(const char* name, double length, double point, double shaft) {
    const Vec3 bend(0.0, 0.0, length);
    const Vec3 back = bend + shaft_length * towards_hand();
    ToolModel tool;
    tool.name = name;
    tool.parts = {{Vec3(0.0, 0.0, point), bend, point, shaft},
                  {bend, back, shaft, shaft},
                  {back, bend + handle_length * towards_hand(), 1.5, 4.0}};
    return tool;
}

}  // namespace

ToolModel cystotome() {
    ToolModel tool = bent("cystotome", 1.0, 0.12, 0.2);
    tool.kind = ToolKind::cystotome;
    tool.cutting = 0.18;  // proposal: it cuts at about 3 mN
    tool.hold = 40000.0;  // proposal
    tool.friction = 0.2;
    return tool;
}

ToolModel capsulorhexis_forceps() {
    ToolModel tool = bent("forceps", 1.0, 0.1, 0.3);
    tool.kind = ToolKind::forceps;
    tool.friction = 0.3;
    tool.reach = 0.3;
    tool.hold = 40000.0;  // proposal: twice the greatest force of a tear
    return tool;
}

ToolModel viscoelastic_cannula() {
    ToolModel tool = bent("cannula", 0.6, 0.2, 0.2);
    tool.kind = ToolKind::cannula;
    tool.friction = 0.1;
    return tool;
}

}  // namespace rhexis
