// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where a thin needle is in a sheet that is torn: in an opening, or through what is not open.
#pragma once

#include <array>
#include <optional>

#include "flow/membrane.hpp"
#include "flow/tool.hpp"

namespace rhexis {

struct SheetPlace {
    int triangle = 0;
    Vec3 now = Vec3::Zero();   ///< [mm]
    Vec3 rest = Vec3::Zero();  ///< [mm]
};

/// Where a needle from its point `a` to `b` goes through a triangle, nearest to its point.
std::optional<SheetPlace> where_through(const MembraneState& state, const Vec3& a, const Vec3& b);

/// How deep a needle's end dents a sheet before it is through [mm].
constexpr double deepest_dent = 0.3;

/// The lip of a tear beside a needle that stands in it, or in the sheet beyond it.
struct NeedleLip {
    std::array<int, 2> nodes{};  ///< ends of the edge
    bool beyond = false;         ///< the needle stands in the sheet beyond the lip: it takes the lip along
    Vec3 needle = Vec3::Zero();  ///< where it stands then, in the sheet at rest [mm]
};

/// The lip that is nearest to a needle which is through the sheet at a tear; none where it is not.
std::optional<NeedleLip> lip_of(const ToolModel& needle, const ToolState& tool, const MembraneState& state);

}  // namespace rhexis
