// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a body as triangles with normals, smooth except across sharp edges.
#pragma once

#include <vector>

#include "flow/membrane.hpp"
#include "flow/shell.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Vertices: position, normal, colour, distance from the three edges as barycentric coordinates (3 floats each).
void append_surface(const SolidModel& model, const SolidState& state, int solid, std::vector<float>& stream);

/// The same for a sheet.
void append_sheet(const MembraneState& state, std::vector<float>& stream);

/// A shell with its thickness.
void append_shell(const ShellModel& model, const ShellState& state, std::vector<float>& stream);

}  // namespace rhexis
