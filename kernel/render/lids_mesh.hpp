// SPDX-License-Identifier: GPL-3.0-or-later
// Lids, lashes and the drape over them as triangles, in the eye's frame.
#pragma once

#include "flow/lids.hpp"
#include "render/tool_mesh.hpp"

namespace rhexis {

ToolMesh lids_mesh(const LidsModel& model, const LidsState& lids);

}  // namespace rhexis
