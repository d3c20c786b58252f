// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solve/past_solutions.hpp"

#include <algorithm>
#include <array>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr std::size_t many = linear_kernel::many;
/// Of a solution's energy, what must be its own, not of later ones: less is lost to rounding.
constexpr double own_share = 1e-11;

using Gram = Eigen::Matrix<double, many, many, Eigen::RowMajor>;
using Factors = Eigen::Matrix<double, many, 1>;

/// Solves with the Gram matrix, in that order; 0 for what depends on those before.
Factors independent_solution(const Gram& gram, const Factors& right, const std::array<int, many>& order) {
    Gram lower = Gram::Zero();  // rows and columns as in `order`
    Factors forward = Factors::Zero();
    for (int i = 0; i < static_cast<int>(many); ++i) {
        const int own = order[at(i)];
        double left = gram(own, own);
        double sum = right[own];
        for (int k = 0; k < i; ++k) {
            if (lower(k, k) > 0.0) {
                const double share =
                    (gram(own, order[at(k)]) - lower.row(i).head(k).dot(lower.row(k).head(k))) / lower(k, k);
                lower(i, k) = share;
                left -= share * share;
                sum -= share * forward[k];
            }
        }
        if (left > own_share * gram(own, own)) {
            lower(i, i) = std::sqrt(left);
            forward[i] = sum / lower(i, i);
        }
    }
    Factors result = Factors::Zero();
    for (int i = static_cast<int>(many); i-- > 0;) {
        if (lower(i, i) > 0.0) {
            double sum = forward[i];
            for (int k = i + 1; k < static_cast<int>(many); ++k) {
                sum -= lower(k, k) > 0.0 ? lower(k, i) * result[order[at(k)]] : 0.0;
            }
            result[order[at(i)]] = sum / lower(i, i);
        }
    }
    return result;
}

}  // namespace

void PastSolutions::project(const CoupledMatrix& matrix, std::span<const double> b, std::span<double> x,
                            std::span<double> image) {
    RHEXIS_ASSERT(any(b.size()));
    matrix.multiply_many(solutions_, images_);
    Gram gram;
    Factors right;
    matrix.kernel().products_many(solutions_.data(), images_.data(), b.data(), size_, gram.data(), right.data());
    std::array<int, many> order{};
    for (std::size_t i = 0; i < many; ++i) {
        order[i] = static_cast<int>((last_ + many - i) % many);
    }
    const Factors factors = independent_solution(gram, right, order);
    matrix.kernel().combine_many(solutions_.data(), factors.data(), size_, x.data());
    matrix.kernel().combine_many(images_.data(), factors.data(), size_, image.data());
}

void PastSolutions::keep(std::span<const double> x) {
    if (!any(x.size())) {
        size_ = x.size();
        count_ = 0;
        solutions_.assign(many * size_, 0.0);
        images_.resize(many * size_);
    }
    count_ = std::min(count_ + 1, many);
    last_ = (last_ + 1) % many;
    for (std::size_t i = 0; i < size_; ++i) {
        solutions_[many * i + last_] = x[i];
    }
}

}  // namespace rhexis
