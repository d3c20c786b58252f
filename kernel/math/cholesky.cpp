// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/cholesky.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/blas.hpp"

namespace rhexis {
namespace {

/// CHOLMOD's workspace, silent.
struct Common : cholmod_common {
    Common() : cholmod_common{} {
        cholmod_start(this);
        print = 0;
        try_catch = 1;
    }
    Common(const Common&) = delete;
    Common& operator=(const Common&) = delete;
    ~Common() { cholmod_finish(this); }
};

struct Sparse {
    cholmod_sparse* matrix;
    Common& common;
    Sparse(std::size_t n, std::size_t entries, int xtype, Common& owner)
        : matrix(cholmod_allocate_sparse(n, n, entries, 1, 1, 1, xtype, &owner)), common(owner) {
        RHEXIS_ASSERT(matrix != nullptr);
    }
    Sparse(const Sparse&) = delete;
    Sparse& operator=(const Sparse&) = delete;
    ~Sparse() { cholmod_free_sparse(&matrix, &common); }
    [[nodiscard]] int* columns() const { return static_cast<int*>(matrix->p); }
    [[nodiscard]] int* rows() const { return static_cast<int*>(matrix->i); }
    [[nodiscard]] double* values() const { return static_cast<double*>(matrix->x); }
};

/// Upper triangle by columns, block entries expanded to 3x3. Column c of block row b lists all earlier block rows.
void fill_scalar_pattern(const BlockPattern& pattern, Sparse& upper) {
    int entry = 0;
    for (int j = 0; j < pattern.rows(); ++j) {
        for (int c = 0; c < 3; ++c) {
            upper.columns()[3 * j + c] = entry;
            for (int slot = pattern.first[at(j)]; slot <= pattern.diagonal[at(j)]; ++slot) {
                const int i = pattern.column[at(slot)];
                const int last = i == j ? c : 2;
                for (int r = 0; r <= last; ++r) {
                    upper.rows()[entry++] = 3 * i + r;
                }
            }
        }
    }
    upper.columns()[3 * pattern.rows()] = entry;
}

std::size_t scalar_entries(const BlockPattern& pattern) {
    const std::size_t off_diagonal = (at(pattern.blocks()) - at(pattern.rows())) / 2;
    return 9 * off_diagonal + 6 * at(pattern.rows());
}

std::vector<int> order_by(const Sparse& graph, int method, double& entries) {
    Common common;
    common.nmethods = 1;
    common.method[0].ordering = method;
    common.postorder = 1;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    cholmod_factor* factor = cholmod_analyze(graph.matrix, &common);
    std::vector<int> order;
    entries = HUGE_VAL;
    if (factor != nullptr) {
        const int* permutation = static_cast<const int*>(factor->Perm);
        order.assign(permutation, permutation + graph.matrix->ncol);
        entries = common.lnz;
        cholmod_free_factor(&factor, &common);
    }
    return order;
}

void fill_graph(const BlockPattern& pattern, Sparse& graph) {
    int entry = 0;
    for (int j = 0; j < pattern.rows(); ++j) {
        graph.columns()[j] = entry;
        for (int slot = pattern.first[at(j)]; slot <= pattern.diagonal[at(j)]; ++slot) {
            graph.rows()[entry++] = pattern.column[at(slot)];
        }
    }
    graph.columns()[pattern.rows()] = entry;
}

std::size_t graph_entries(const BlockPattern& pattern) {
    return (at(pattern.blocks()) - at(pattern.rows())) / 2 + at(pattern.rows());
}

}  // namespace

struct Cholesky::Parts {
    Parts(const BlockPattern& blocks, CholeskyKind kind)
        : pattern(blocks), upper(3 * at(blocks.rows()), scalar_entries(blocks), CHOLMOD_REAL, common) {
        fill_scalar_pattern(pattern, upper);
        if (kind == CholeskyKind::supernodal) {
            use_one_blas_thread();
        }
        common.supernodal = kind == CholeskyKind::supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        common.final_ll = kind == CholeskyKind::indefinite ? 0 : 1;
        common.quick_return_if_not_posdef = 1;
        factor = cholmod_analyze(upper.matrix, &common);
        RHEXIS_ASSERT(factor != nullptr);
    }
    ~Parts() {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work_y, &common);
        cholmod_free_dense(&work_e, &common);
        cholmod_free_factor(&factor, &common);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void copy_values(const BlockValues& values) {
        double* target = upper.values();
        for (int j = 0; j < pattern.rows(); ++j) {
            for (int c = 0; c < 3; ++c) {
                for (int slot = pattern.first[at(j)]; slot <= pattern.diagonal[at(j)]; ++slot) {
                    // the block (j, i) is the transpose of (i, j): row c of it is column c of the other
                    const int last = slot == pattern.diagonal[at(j)] ? c : 2;
                    for (int r = 0; r <= last; ++r) {
                        *target++ = values[9 * at(slot) + at(3 * r + c)];
                    }
                }
            }
        }
    }

    BlockPattern pattern;
    Common common;
    Sparse upper;
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;
    cholmod_dense* work_y = nullptr;
    cholmod_dense* work_e = nullptr;
    bool valid = false;
};

Cholesky::Cholesky(const BlockPattern& pattern, CholeskyKind kind) : parts_(std::make_unique<Parts>(pattern, kind)) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

bool Cholesky::factor(const BlockValues& values) {
    Parts& parts = *parts_;
    parts.valid = false;
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
        return false;
    }
    parts.copy_values(values);
    const int status = cholmod_factorize(parts.upper.matrix, parts.factor, &parts.common);
    parts.valid = status != 0 && parts.common.status == CHOLMOD_OK && parts.factor->minor == parts.factor->n;
    return parts.valid;
}

bool Cholesky::factored() const { return parts_->valid; }

int Cholesky::negative_pivots() const {
    const cholmod_factor& factor = *parts_->factor;
    if (!parts_->valid || factor.is_ll != 0) {
        return 0;
    }
    const int* const column = static_cast<const int*>(factor.p);
    const double* const value = static_cast<const double*>(factor.x);
    int count = 0;
    for (std::size_t j = 0; j < factor.n; ++j) {
        count += value[column[j]] < 0.0 ? 1 : 0;
    }
    return count;
}

void Cholesky::solve(std::span<const double> b, std::span<double> x) {
    Parts& parts = *parts_;
    const std::size_t n = parts.upper.matrix->ncol;
    RHEXIS_ASSERT(parts.valid && b.size() >= n && x.size() >= n);
    cholmod_dense right{};
    right.nrow = n;
    right.ncol = 1;
    right.nzmax = n;
    right.d = n;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    const int status = cholmod_solve2(CHOLMOD_A, parts.factor, &right, nullptr, &parts.solution, nullptr, &parts.work_y,
                                      &parts.work_e, &parts.common);
    RHEXIS_ASSERT(status != 0);
    static_cast<void>(status);
    const double* result = static_cast<const double*>(parts.solution->x);
    std::copy(result, result + n, x.begin());
}

long Cholesky::entries() const {
    const cholmod_factor& factor = *parts_->factor;
    return static_cast<long>(factor.is_super != 0 ? factor.xsize : factor.nzmax);
}

std::vector<int> elimination_order(const BlockPattern& pattern) {
    Common common;
    Sparse graph(at(pattern.rows()), graph_entries(pattern), CHOLMOD_PATTERN, common);
    fill_graph(pattern, graph);
    double entries = HUGE_VAL;
    double other_entries = HUGE_VAL;
    std::vector<int> order = order_by(graph, CHOLMOD_AMD, entries);
    std::vector<int> other = order_by(graph, CHOLMOD_METIS, other_entries);
    RHEXIS_ASSERT(!order.empty());
    return other_entries < entries ? other : order;
}

}  // namespace rhexis
