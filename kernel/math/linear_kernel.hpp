// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of sparse linear algebra, compiled once per instruction set from one source (linear_kernel.ipp).
// Every number is made by the same operations in the same order whatever the width of the registers, without fused
// multiply-add, so the bits are the same on every x86-64 machine.
// This header declares plain data only: an inline function compiled for one instruction set must never be linked into
// code for another.
#pragma once

#include <cstddef>
#include <string_view>

namespace rhexis::linear_kernel {

inline constexpr int row_block = 64;   ///< rows of a panel that are stored together
inline constexpr int row_unit = 8;     ///< rows are padded to a multiple of this
inline constexpr int front_unit = 16;  ///< column length of fronts is padded to a multiple of this

/// A panel of a packed factor L: the inverse of its triangle, then the rows below, each as blocks of at most 64 rows by
/// columns, rows padded with zeros to a multiple of 8. Vectors hold 4 numbers per node, the fourth 0.
struct Panel {
    int first_node = 0;
    int width = 0;        ///< columns, 3 per node
    int below_nodes = 0;  ///< block rows below
    int row = 0;          ///< into the list of their nodes
    std::size_t triangle = 0;
    std::size_t below = 0;
};

/// A symmetric block matrix with both triangles.
struct Blocks {
    int rows = 0;
    const int* first = nullptr;
    const int* column = nullptr;
    const double* value = nullptr;  ///< 9 per block by columns, one number of padding at the end
};

struct Kernel {
    const char* name;
    /// Partial Cholesky of a front by columns: the first `pivots` (a multiple of 3) of `size` columns are eliminated,
    /// the rest holds what is left. Only the lower triangle counts. False if a pivot is not positive.
    bool (*eliminate)(float* front, int leading, int pivots, int size);
    /// The inverse of `columns` columns of a lower triangle, by rows of length `columns` rounded up to front_unit.
    void (*invert)(const float* triangle, int leading, int columns, float* inverse);
    /// Adds the lower triangle of `nodes` block rows by columns to a front; place: block rows in the front, ascending.
    void (*extend)(const float* source, const int* place, int nodes, float* front, int leading);
    /// x = L'^-1 L^-1 x; work: 9 numbers for each of the widest panel's columns and longest panel's rows.
    void (*solve)(const Panel* panels, int count, const float* values, const int* nodes, float* x, float* work);
    /// y = A x, 3 numbers per row; both arrays with one number of padding at the end.
    void (*multiply)(const Blocks& matrix, const double* x, double* y);
    /// Sum of products in a fixed order.
    double (*dot)(const double* a, const double* b, std::size_t n);
};

/// Of the machine's best instruction set, or of the named one ("baseline", "avx2", "avx512"); null if there is none.
const Kernel* choose(std::string_view instruction_set = {});

const Kernel* baseline();
const Kernel* avx2();
const Kernel* avx512();

}  // namespace rhexis::linear_kernel
