// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/updown_factor.hpp"

#include <cholmod.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis::bench {
namespace {

constexpr double negligible = 1e-12;  // eigenvalues of a change, over the largest

struct Common : cholmod_common {
    Common() : cholmod_common{} {
        cholmod_start(this);
        print = 0;
        try_catch = 1;
        supernodal = CHOLMOD_SIMPLICIAL;
        final_ll = 0;
        final_pack = 0;  // room for columns to grow
        nmethods = 1;
    }
    Common(const Common&) = delete;
    Common& operator=(const Common&) = delete;
    ~Common() { cholmod_finish(this); }
};

std::size_t upper_entries(const BlockPattern& pattern, int spare) {
    return 9 * (at(pattern.blocks()) - at(pattern.rows())) / 2 + 6 * at(pattern.rows()) + 3 * at(spare);
}

/// Upper triangle by columns.
void fill_upper(const BlockPattern& pattern, const BlockValues& values, int spare, double diagonal,
                cholmod_sparse& upper) {
    int* const first = static_cast<int*>(upper.p);
    int* const row = static_cast<int*>(upper.i);
    double* const value = static_cast<double*>(upper.x);
    int entry = 0;
    for (int j = 0; j < pattern.rows(); ++j) {
        for (int c = 0; c < 3; ++c) {
            first[3 * j + c] = entry;
            for (int slot = pattern.first[at(j)]; slot <= pattern.diagonal[at(j)]; ++slot) {
                const int last = slot == pattern.diagonal[at(j)] ? c : 2;
                for (int r = 0; r <= last; ++r, ++entry) {
                    // row c of block (j, i) is column c of (i, j)
                    row[entry] = 3 * pattern.column[at(slot)] + r;
                    value[entry] = values[9 * at(slot) + at(3 * r + c)];
                }
            }
        }
    }
    for (int i = 3 * pattern.rows(); i < 3 * (pattern.rows() + spare); ++i, ++entry) {
        first[i] = entry;
        row[entry] = i;
        value[entry] = diagonal;
    }
    first[3 * (pattern.rows() + spare)] = entry;
}

}  // namespace

struct UpdownFactor::Parts {
    Parts() = default;
    ~Parts() {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work_y, &common);
        cholmod_free_dense(&work_e, &common);
        cholmod_free_factor(&factor, &common);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    [[nodiscard]] bool positive() const {
        return common.status == CHOLMOD_OK && factor != nullptr && factor->minor == factor->n;
    }
    bool add(std::span<const int> rows, const MatX& columns, bool update);

    Common common;
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr;
    cholmod_dense* work_y = nullptr;
    cholmod_dense* work_e = nullptr;
};

UpdownFactor::UpdownFactor() : parts_(std::make_unique<Parts>()) {}
UpdownFactor::~UpdownFactor() = default;

bool UpdownFactor::factor(const BlockPattern& pattern, const BlockValues& values, Order order, int spare,
                          double diagonal) {
    Parts& p = *parts_;
    cholmod_free_factor(&p.factor, &p.common);
    const std::size_t n = 3 * at(pattern.rows() + spare);
    cholmod_sparse* upper =
        cholmod_allocate_sparse(n, n, upper_entries(pattern, spare), 1, 1, 1, CHOLMOD_REAL, &p.common);
    RHEXIS_ASSERT(upper != nullptr);
    fill_upper(pattern, values, spare, diagonal, *upper);
    p.common.method[0].ordering = order == Order::given ? CHOLMOD_NATURAL : CHOLMOD_AMD;
    p.common.postorder = order == Order::given ? 0 : 1;
    p.factor = cholmod_analyze(upper, &p.common);
    const bool done = p.factor != nullptr && cholmod_factorize(upper, p.factor, &p.common) != 0;
    cholmod_free_sparse(&upper, &p.common);
    return done && p.positive();
}

/// L D L^T += or -= C C^T.
bool UpdownFactor::Parts::add(std::span<const int> rows, const MatX& columns, bool update) {
    const std::size_t rank = static_cast<std::size_t>(columns.cols());
    const std::size_t height = 3 * rows.size();
    if (rank == 0) {
        return true;
    }
    cholmod_sparse* c = cholmod_allocate_sparse(factor->n, rank, rank * height, 1, 1, 0, CHOLMOD_REAL, &common);
    RHEXIS_ASSERT(c != nullptr);
    for (std::size_t k = 0; k <= rank; ++k) {
        static_cast<int*>(c->p)[k] = static_cast<int>(k * height);
    }
    for (std::size_t k = 0; k < rank; ++k) {
        for (std::size_t i = 0; i < height; ++i) {
            static_cast<int*>(c->i)[k * height + i] = 3 * rows[i / 3] + static_cast<int>(i % 3);
            static_cast<double*>(c->x)[k * height + i] =
                columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
        }
    }
    const int status = cholmod_updown(update ? 1 : 0, c, factor, &common);
    cholmod_free_sparse(&c, &common);
    return status != 0 && positive();
}

bool UpdownFactor::change(std::span<const int> rows, const MatX& value) {
    if (rows.empty()) {
        return true;
    }
    const Eigen::SelfAdjointEigenSolver<MatX> parts(value);
    const VecX& size = parts.eigenvalues();  // ascending
    const double limit = negligible * std::max(std::abs(size[0]), std::abs(size[size.size() - 1]));
    const Eigen::Index negative = (size.array() < -limit).count();
    const Eigen::Index positive = (size.array() > limit).count();
    const MatX up = parts.eigenvectors().rightCols(positive) * size.tail(positive).cwiseSqrt().asDiagonal();
    const MatX down = parts.eigenvectors().leftCols(negative) * (-size.head(negative)).cwiseSqrt().asDiagonal();
    return parts_->add(rows, up, true) && parts_->add(rows, down, false);
}

void UpdownFactor::solve(std::span<const double> b, std::span<double> x) {
    Parts& p = *parts_;
    const std::size_t n = p.factor->n;
    RHEXIS_ASSERT(b.size() >= n && x.size() >= n);
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = n;
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, p.factor, &right, nullptr, &p.solution, nullptr, &p.work_y, &p.work_e, &p.common);
    const double* result = static_cast<const double*>(p.solution->x);
    std::copy(result, result + n, x.begin());
}

long UpdownFactor::entries() const {
    const cholmod_factor& factor = *parts_->factor;
    long sum = 0;
    for (std::size_t j = 0; j < factor.n; ++j) {
        sum += static_cast<const int*>(factor.nz)[j];
    }
    return sum;
}

}  // namespace rhexis::bench
