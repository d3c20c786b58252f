// SPDX-License-Identifier: GPL-3.0-or-later
// Inside topology: a piece of a sheet that leaves the eye.
#pragma once

#include "flow/membrane_edit.hpp"

namespace rhexis {

/// The state without the triangles that an edit takes out, and without what held or touched them.
MembraneState without(const MembraneState& state, const MembraneEdit& edit);

}  // namespace rhexis
