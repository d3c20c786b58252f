// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loop of MembraneBody, compiled once per instruction set from one source (membrane_kernel.ipp): forces and
// stiffness of eight triangles of a sheet at a time, in double, by the formulas of energy/membrane_triangle.hpp. Lanes
// are computed independently, and added to the nodes one triangle after the other, so the bits are the same for every
// instruction set.
// This header declares plain data only: an inline function compiled for one instruction set must never be linked into
// code for another.
#pragma once

#include <string_view>

namespace rhexis::membrane_kernel {

inline constexpr int lanes = 8;
inline constexpr int numbers = 14;  ///< per triangle
inline constexpr int places = 9;    ///< per triangle

/// Which stiffness: none, or one of MembraneTangent (energy/membrane_triangle.hpp).
enum class Mode { forces, consistent, definite };

struct Task {
    /// Per group of eight triangles `numbers` times eight: x and y of three gradients [1/mm], volume [mm^3], entries
    /// 00, 01, 02, 11, 12, 22 of the stiffness [Pa], share of it in compression. A lane without a triangle: all 0.
    const double* data = nullptr;
    /// Per group `places` times eight: rows of the corners, ascending, then 9 times the slots of their pairs 00, 01,
    /// 11, 02, 12, 22.
    const int* index = nullptr;
    int groups = 0;
    Mode mode = Mode::forces;
    double scale = 1.0;                ///< on the stiffness
    const double* position = nullptr;  ///< 3 per row [mm]
    double* force = nullptr;           ///< 3 per row, added to [uN]
    double* stiffness = nullptr;       ///< blocks by columns, added to [uN/mm]
};

struct Kernel {
    const char* name;
    void (*assemble)(const Task& task);
};

/// Of the machine's best instruction set, or of the named one; null if there is none.
const Kernel* choose(std::string_view instruction_set);

const Kernel* baseline();
const Kernel* avx2();
const Kernel* avx512();

}  // namespace rhexis::membrane_kernel
