// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loop of ShellBody, compiled once per instruction set from one source (shell_kernel.ipp, with the formulas
// of energy/shell_triangle.ipp): forces and stiffness of eight shell triangles at a time. Lanes are computed
// independently and added to the rows one triangle after the other, so the bits are the same for every instruction set.
// This header declares plain data only: an inline function compiled for one instruction set must never be linked into
// code for another.
#pragma once

#include <string_view>

namespace rhexis::shell_kernel {

inline constexpr int lanes = 8;
inline constexpr int data_length = 129;  ///< numbers per triangle: Rest of the formula, in the order of its members
inline constexpr int index_length = 24;  ///< per triangle: ranks of its corners, then 21 places in the stiffness
inline constexpr int buffer_length = 18 + 189;

inline constexpr int natural_place = 114;    ///< of the natural deformation in a triangle's numbers
inline constexpr int natural_length = 15;    ///< of it and of a deformation, per triangle
inline constexpr int predicted_length = 18;  ///< per triangle: forces, then moments of its corners, in its frame

/// What is computed besides forces; predict, deformation: nothing but that.
enum class Mode { forces, consistent, definite, predict, deformation };

/// Rows come in pairs: 2 k the movement, 2 k + 1 the turn of the node of rank k.
struct Task {
    const double* data = nullptr;  ///< groups of eight triangles; data_length times eight numbers each
    const int* index = nullptr;    ///< index_length times eight each; a place is 9 times a slot
    int groups = 0;
    Mode mode = Mode::forces;
    double scale = 1.0;                ///< on the stiffness
    const double* position = nullptr;  ///< 3 per row
    const double* rotation = nullptr;  ///< 9 per rank, by rows
    double* force = nullptr;           ///< 3 per row, added to
    double* stiffness = nullptr;       ///< blocks by columns, added to; per movement and spin
    double* buffer = nullptr;          ///< lanes * buffer_length
    double* predicted = nullptr;    ///< groups as data; consistent: the stress in the stiffness, or null for the true
    double* deformation = nullptr;  ///< groups as data, 15 per triangle
    const double* step = nullptr;   ///< predict: 3 per row, movements and spins
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

}  // namespace rhexis::shell_kernel
