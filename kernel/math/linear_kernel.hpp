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

inline constexpr int row_block = 64;   ///< rows of a panel that a solve takes together
inline constexpr int row_unit = 8;     ///< rows of a solve are padded to a multiple of this
inline constexpr int front_unit = 16;  ///< column length of fronts is padded to a multiple of this
inline constexpr int many = 8;         ///< vectors side by side: all of the first number, then all of the next

/// A panel of a packed factor L: the inverse of its triangle, by columns of its width rounded up to row_unit, then the
/// rows below, by columns of `leading`; padded with zeros. Vectors hold 4 numbers per node, the fourth 0.
struct Panel {
    int first_node = 0;
    int width = 0;        ///< columns, 3 per node, at most row_block
    int below_nodes = 0;  ///< block rows below
    int row = 0;          ///< into the list of their nodes
    int leading = 0;      ///< their rows rounded up to front_unit
    std::size_t triangle = 0;
    std::size_t below = 0;
};

/// The part of a matrix that is dense while some columns are eliminated. All by columns whose length is padded to a
/// multiple of front_unit, and front_unit numbers behind the last; only the lower triangle counts.
struct Front {
    float* pivot = nullptr;  ///< columns to eliminate, their own rows
    float* below = nullptr;  ///< the same columns, the rows below
    float* rest = nullptr;   ///< columns of the rows below
    int pivots = 0;          ///< multiples of 3
    int pivot_leading = 0;
    int below_rows = 0;
    int below_leading = 0;
    bool fresh = true;  ///< nothing is in rest yet, not even zeros
};

/// Block rows that follow one another both in what a panel left and in the front that takes it over.
struct Run {
    int from = 0;
    int place = 0;  ///< in the front; a run does not go from its pivots to the rows below
    int nodes = 0;
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
    /// Starts a front with its entries of a matrix, whose columns they are from block column `first` on. diagonal:
    /// slots; place: block rows in the front, by slots.
    void (*gather)(const Blocks& matrix, const int* diagonal, const int* place, int first, const Front& front);
    /// Adds what an earlier panel left.
    void (*extend)(const float* source, int leading, const Run* runs, int count, const Front& front);
    /// Partial Cholesky: `rest` holds what is left. False if a pivot is not positive.
    bool (*eliminate)(const Front& front);
    /// The inverse of `columns` columns of a lower triangle, by columns of length `columns` rounded up to row_unit.
    /// work: columns times columns rounded up to front_unit.
    void (*invert)(const float* triangle, int leading, int columns, float* work, float* inverse);
    /// x = L'^-1 L^-1 x; work: 9 numbers for each of the widest panel's columns and longest panel's rows.
    void (*solve)(const Panel* panels, int count, const float* values, const int* nodes, float* x, float* work);
    /// y = A x, 3 numbers per row; both arrays with one number of padding at the end.
    void (*multiply)(const Blocks& matrix, const double* x, double* y);
    /// The same of `many` vectors side by side.
    void (*multiply_many)(const Blocks& matrix, const double* x, double* y);
    /// Of `many` vectors of n numbers side by side: products of each of x with each of y (by rows of x) and with b.
    void (*products_many)(const double* x, const double* y, const double* b, std::size_t n, double* with_y,
                          double* with_b);
    /// The sum of `many` vectors of n numbers side by side, each times its factor.
    void (*combine_many)(const double* x, const double* factors, std::size_t n, double* sum);
    /// Sum of products in a fixed order.
    double (*dot)(const double* a, const double* b, std::size_t n);
};

/// Of the machine's best instruction set, or of the named one ("baseline", "avx2", "avx512"); null if there is none.
const Kernel* choose(std::string_view instruction_set = {});

const Kernel* baseline();
const Kernel* avx2();
const Kernel* avx512();

}  // namespace rhexis::linear_kernel
