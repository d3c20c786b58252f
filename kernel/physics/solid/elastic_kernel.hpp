// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loop of ElasticAssembly, compiled once per instruction set from one source (elastic_kernel.ipp): forces and
// stiffness of eight corotational elements at a time, in double. Lanes are computed independently, and added to the
// nodes one element after the other, so the bits are the same for every instruction set.
// This header declares plain data only: an inline function compiled for one instruction set must never be linked into
// code for another.
#pragma once

#include <string_view>

namespace rhexis::elastic_kernel {

inline constexpr int lanes = 8;
inline constexpr int most_nodes = 40;  ///< of an element

/// Eight elements of up to `nodes` nodes. Data, eight numbers each: 2 mu V, lambda V, then three rest gradients per
/// node. Indices, eight each: rows of the nodes, then for each pair a <= b of them its place in the stiffness: 9 times
/// the slot of (row a, row b). Unused nodes have gradient zero and any row; unused lanes have no stiffness.
struct Group {
    int nodes = 0;
    const double* data = nullptr;
    const int* index = nullptr;
};

/// Which stiffness: the three of Tangent (energy/corotational.hpp), or forces alone.
enum class Mode { forces, consistent, warped, projected };

/// The rotation in a deformation gradient where the closed form fails; both by columns.
using SingularRotation = void (*)(const double* gradient, double* rotation);

struct Task {
    const Group* groups = nullptr;
    int count = 0;
    Mode mode = Mode::warped;
    double scale = 1.0;                ///< on the stiffness
    const double* position = nullptr;  ///< 3 per row, one number of padding at the end
    double* force = nullptr;           ///< 3 per row, added to
    double* stiffness = nullptr;       ///< blocks by columns, added to
    double* buffer = nullptr;          ///< 8 * buffer_length(most nodes of a group)
    SingularRotation singular = nullptr;
};

constexpr int buffer_length(int nodes) {
    return (3 * nodes + 9 * (nodes * (nodes + 1) / 2) + lanes - 1) / lanes * lanes;
}

struct Kernel {
    const char* name;
    void (*assemble)(const Task& task);
};

/// Of the machine's best instruction set, or of the named one; null if there is none.
const Kernel* choose(std::string_view instruction_set);

const Kernel* baseline();
const Kernel* avx2();
const Kernel* avx512();

}  // namespace rhexis::elastic_kernel
