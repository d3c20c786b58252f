// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra in compact patches of a few.
#pragma once

#include <array>
#include <vector>

namespace rhexis {

/// Each tetrahedron is in one patch, its neighbours across faces first, so that a patch hangs together and has few
/// nodes. Patches have `most` tetrahedra (at least 1) or, where too few were left, fewer; one of less than half of that
/// joins the smallest that it touches.
std::vector<std::vector<int>> tet_patches(const std::vector<std::array<int, 4>>& tets, int most);

}  // namespace rhexis
