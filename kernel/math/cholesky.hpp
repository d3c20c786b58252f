// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky factors from CHOLMOD, wrapped once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "math/block_matrix.hpp"

namespace rhexis {

/// Simplicial: one thread and the same bits on every machine. Supernodal: dense blocks through BLAS, faster for larger
/// systems, but its last bits depend on the BLAS core and thread count. Indefinite: L D L^T, simplicial, of any
/// symmetric matrix whose elimination meets no zero.
enum class CholeskyKind { simplicial, supernodal, indefinite };

/// L L^T = P A P^T of a symmetric positive definite block matrix with a fixed pattern.
class Cholesky {
public:
    /// Orders and analyses; the pattern is copied.
    Cholesky(const BlockPattern& pattern, CholeskyKind kind);
    ~Cholesky();
    Cholesky(Cholesky&&) noexcept;
    Cholesky& operator=(Cholesky&&) noexcept;

    /// False if the matrix is not positive definite (to rounding; indefinite: not regular) or not finite; then there is
    /// no factor.
    bool factor(const BlockValues& values);
    [[nodiscard]] bool factored() const;
    /// Negative eigenvalues of the matrix that was factored; 0 unless indefinite.
    [[nodiscard]] int negative_pivots() const;

    /// x = A^-1 b.
    void solve(std::span<const double> b, std::span<double> x);

    /// Entries of the factor.
    [[nodiscard]] long entries() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// A fill-reducing order of the block rows: order[k] is the row eliminated k-th. The better, by the entries of the
/// factor, of minimum degree and nested dissection.
std::vector<int> elimination_order(const BlockPattern& pattern);

}  // namespace rhexis
